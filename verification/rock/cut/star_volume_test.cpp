#include "rock/cut/star_volume.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "reference/mesh/exact_volume.hpp"
#include "reference/rock/close_surface.hpp"
#include "reference/rock/prism.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"

namespace tdbd::rock::star_volume_test {
namespace {

/// The sheet spans 2 m and moves by up to 0.3 m; sums of some hundred products of its coordinates.
constexpr double rounding = 3e-15 * 8.0;

mesh::Surface random_sheet() {
  return mesh::make_surface(
      battery::bumpy_rock(1.0, *rc::gen::inRange(3, 8), 0.3, *rc::gen::arbitrary<std::uint64_t>()));
}

/// Moves about half of the inner vertices, one after another, and returns the sum of what each removed.
double move_one_by_one(mesh::Surface& s) {
  double sum = 0.0;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (s.is_boundary(v) || *rc::gen::arbitrary<bool>()) continue;
    const Vec3 d = *battery::point(0.3);
    sum += star_volume(s, v, d);
    s.place(v, s.position(v) + d);
  }
  return sum;
}

double sum_of_prisms(const mesh::Surface& before, const mesh::Surface& after) {
  double sum = 0.0;
  for (const mesh::Triangle& t : before.triangles)
    sum += reference::prism_volume(
        {before.position(t[0]), before.position(t[1]), before.position(t[2])},
        {after.position(t[0]), after.position(t[1]), after.position(t[2])});
  return sum;
}

}  // namespace

/// Each vertex alone, or all at once along straight lines: the same volume.
RC_GTEST_PROP(StarVolume, summed_over_moves_is_the_sum_of_the_prisms, ()) {
  const mesh::Surface before = random_sheet();
  mesh::Surface after = before;
  const double sum = move_one_by_one(after);
  RC_ASSERT(std::abs(sum - sum_of_prisms(before, after)) < rounding);
}

RC_GTEST_PROP(StarVolume, summed_over_moves_is_what_the_hole_gains, ()) {
  const mesh::Surface before = random_sheet();
  mesh::Surface after = before;
  const double sum = move_one_by_one(after);
  RC_ASSERT(std::abs(sum - (mesh::hole_volume(after, Vec3::Zero()) -
                            mesh::hole_volume(before, Vec3::Zero()))) < rounding);
}

/// The tip of a flat fan of area 2 lowered by 3/4: a pyramid of volume 1/2 is removed.
TEST(StarVolume, of_a_pyramid) {
  mesh::TriangleMesh m{
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}, {}};
  for (int i = 0; i < 4; ++i) m.triangles.push_back({0, 1 + i, 1 + (i + 1) % 4});
  EXPECT_DOUBLE_EQ(star_volume(mesh::make_surface(m), 0, Vec3(0.1, 0.2, 0.75)),
                   0.5);  // z points down, the normal up
}

}  // namespace tdbd::rock::star_volume_test

#include "reference/mesh/exact_volume.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "reference/mesh/exact_rational.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::exact_volume_test {

using mesh::TriangleMesh;

/// A flat rock whose inner vertices went anywhere; its boundary is fixed.
TriangleMesh moved_inside(TriangleMesh m, double half) {
  for (Vec3& x : m.positions)
    if (x.head<2>().cwiseAbs().maxCoeff() < half) x += *battery::point(0.5);
  return m;
}

TEST(ExactVolume, of_a_tetrahedron) {
  const TriangleMesh m{{{8, 8, 8}, {9, 8, 8}, {8, 9, 8}, {8, 8, 9}},
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_TRUE(signed_volume_rational(m) == Rational(1, 6));
  EXPECT_DOUBLE_EQ(enclosed_volume_exact(m), 1.0 / 6.0);
}

/// Far from the origin rounding would leave nothing of the volume; exact arithmetic keeps all of
/// it.
TEST(ExactVolume, of_a_small_box_far_away) {
  const Vec3 far = Vec3::Constant(1e9);
  EXPECT_EQ(enclosed_volume_exact(battery::box(far, far + Vec3(1, 2, 3))), 6.0);
}

TEST(ExactVolume, of_an_inverted_box_is_negative) {
  TriangleMesh m = battery::box({0, 0, 0}, {1, 1, 1});
  for (mesh::Triangle& f : m.triangles) std::swap(f[0], f[1]);
  EXPECT_EQ(enclosed_volume_exact(m), -1.0);
}

TEST(RemovedVolumeExact, of_a_rock_lowered_as_a_whole_is_area_times_depth) {
  const TriangleMesh before = battery::flat_rock(1.0, 0.0, 4),
                     after = battery::flat_rock(1.0, 0.25, 4);
  EXPECT_EQ(removed_volume_exact(before, after), 1.0);
  EXPECT_EQ(removed_volume_exact(after, before), -1.0);
}

/// One vertex of a 2 x 2 rock goes down by h: the volume of the pyramid over its ring (area 3).
TEST(RemovedVolumeExact, of_one_vertex_is_a_pyramid) {
  const TriangleMesh before = battery::flat_rock(1.0, 0.0, 2);
  TriangleMesh after = before;
  after.positions[4].z() = 0.5;
  EXPECT_EQ(removed_volume_exact(before, after), 3.0 * 0.5 / 3.0);
}

TEST(RemovedVolumeExact, refuses_surfaces_with_different_triangles) {
  EXPECT_THROW(
      removed_volume_exact(battery::flat_rock(1.0, 0.0, 2), battery::flat_rock(1.0, 0.0, 3)),
      RunError);
}

RC_GTEST_PROP(PrismVolume, is_the_change_of_enclosed_volume_exactly, ()) {
  const TriangleMesh before = *battery::star_shape(), after = *battery::star_shape();
  RC_ASSERT(prism_volume_rational(before, after) ==
            signed_volume_rational(after) - signed_volume_rational(before));
}

RC_GTEST_PROP(PrismVolume, is_the_change_of_an_open_surface_with_fixed_boundary_exactly, ()) {
  const TriangleMesh flat = battery::flat_rock(1.0, 0.5, 4);
  const TriangleMesh before = moved_inside(flat, 1.0), after = moved_inside(flat, 1.0);
  RC_ASSERT(prism_volume_rational(before, after) ==
            signed_volume_rational(after) - signed_volume_rational(before));
}

RC_GTEST_PROP(PrismVolume, adds_up_over_steps_exactly, ()) {
  const TriangleMesh flat = battery::flat_rock(1.0, 0.5, 3);
  const TriangleMesh middle = moved_inside(flat, 1.0), last = moved_inside(middle, 1.0);
  RC_ASSERT(prism_volume_rational(flat, middle) + prism_volume_rational(middle, last) ==
            prism_volume_rational(flat, last));
}

}  // namespace tdbd::reference::exact_volume_test

#include "verification/battery/shapes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "reference/mesh/exact_volume.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::battery::shapes_test {

using mesh::TriangleMesh;
using reference::enclosed_volume_exact;

/// Closed and oriented: every directed edge occurs once, and so does its opposite.
bool closed_and_oriented(const TriangleMesh& m) {
  std::map<std::pair<int, int>, int> uses;
  for (const mesh::Triangle& f : m.triangles)
    for (int i = 0; i < 3; ++i) ++uses[{f[i], f[(i + 1) % 3]}];
  for (const auto& [edge, count] : uses)
    if (count != 1 || !uses.contains({edge.second, edge.first})) return false;
  return true;
}

void expect_sound(const TriangleMesh& m) {
  EXPECT_TRUE(closed_and_oriented(m));
  EXPECT_GT(enclosed_volume_exact(m), 0.0);
  EXPECT_EQ(reference::self_intersecting_pairs(m), 0u);
}

TEST(Shapes, are_closed_oriented_and_do_not_intersect_themselves) {
  expect_sound(box({-1, -2, -3}, {1, 2, 3}));
  expect_sound(cylinder(2.0, 3.0, 7));
  expect_sound(torus(3.0, 1.0, 12, 8));
  expect_sound(sphere(2.0, 2));
  expect_sound(prism(l_outline(2.0, 0.5), 0.0, 1.0));
  expect_sound(prism(u_outline(2.0, 0.5), 0.0, 1.0));
  expect_sound(prism(star_outline(2.0, 0.5, 5), 0.0, 1.0));
}

TEST(Shapes, have_the_volumes_of_their_closed_forms) {
  EXPECT_EQ(enclosed_volume_exact(box({-1, -2, -3}, {1, 2, 3})), 48.0);
  EXPECT_DOUBLE_EQ(enclosed_volume_exact(prism(l_outline(2.0, 0.5), 0.0, 1.0)), 1.75);
  EXPECT_DOUBLE_EQ(enclosed_volume_exact(prism(u_outline(2.0, 0.5), 0.0, 1.0)), 2.5);
  const double hexagon = 1.5 * std::sqrt(3.0);
  EXPECT_NEAR(enclosed_volume_exact(cylinder(1.0, 2.0, 6)), 2.0 * hexagon, 1e-14);
  EXPECT_NEAR(enclosed_volume_exact(sphere(1.0, 4)), 4.0 / 3.0 * std::numbers::pi, 0.01);
  EXPECT_NEAR(enclosed_volume_exact(torus(3.0, 1.0, 200, 200)),
              6.0 * std::numbers::pi * std::numbers::pi, 0.05);
}

TEST(Shapes, sphere_has_its_vertices_on_the_sphere) {
  const TriangleMesh m = sphere(2.0, 2);
  EXPECT_EQ(m.triangles.size(), 320u);
  for (const Vec3& x : m.positions) EXPECT_NEAR(x.norm(), 2.0, 1e-15);
}

TEST(Shapes, flat_rock_faces_up) {
  const TriangleMesh m = flat_rock(2.0, 1.0, 3);
  EXPECT_EQ(m.triangles.size(), 18u);
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3 normal = (m.positions[b] - m.positions[a]).cross(m.positions[c] - m.positions[a]);
    EXPECT_LT(normal.z(), 0.0);
  }
}

/// Every integer of a range turns up, none far oftener than the others, whatever the test's size.
TEST(Generators, integers_fill_their_range_evenly) {
  for (const auto& [first, last] : {std::pair(-3, 5), std::pair(-5, 2), std::pair(2, 9),
                                    std::pair(-9, -4), std::pair(-4, 4), std::pair(7, 7)}) {
    std::map<int, int> count;
    constexpr int draws = 2000;
    for (int k = 0; k < draws; ++k)
      ++count[integer(first, last)(rc::Random(static_cast<std::uint64_t>(k)), 0).value()];
    ASSERT_EQ(count.size(), static_cast<std::size_t>(last - first + 1));
    EXPECT_EQ(count.begin()->first, first);
    EXPECT_EQ(count.rbegin()->first, last);
    for (const auto& [value, n] : count) EXPECT_GT(n, draws / (2 * (last - first + 1))) << value;
  }
}

RC_GTEST_PROP(Generators, rotations_are_rotations, ()) {
  const Mat3 R = *rotation();
  RC_ASSERT((R.transpose() * R - Mat3::Identity()).norm() < 1e-14);
  RC_ASSERT(std::abs(R.determinant() - 1.0) < 1e-14);
}

RC_GTEST_PROP(Generators, convex_polyhedra_have_all_vertices_behind_every_face, ()) {
  const TriangleMesh m = *convex_polyhedron();
  RC_ASSERT(closed_and_oriented(m));
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3 normal = (m.positions[b] - m.positions[a]).cross(m.positions[c] - m.positions[a]);
    for (const Vec3& x : m.positions) RC_ASSERT(normal.dot(x - m.positions[a]) < 1e-12);
  }
}

RC_GTEST_PROP(Generators, star_shapes_see_all_faces_from_the_origin, ()) {
  const TriangleMesh m = *star_shape();
  RC_ASSERT(closed_and_oriented(m));
  for (const auto& [a, b, c] : m.triangles)
    RC_ASSERT(m.positions[a].dot(m.positions[b].cross(m.positions[c])) > 0.0);
}

}  // namespace tdbd::battery::shapes_test

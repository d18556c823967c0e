#include "reference/mesh/exact_volume.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "reference/mesh/exact_rational.hpp"
#include "reference/mesh/hausdorff.hpp"
#include "reference/mesh/self_intersections.hpp"
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

TEST(RemovedVolumeExact, rejects_surfaces_with_different_triangles) {
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

/// The corners of a prism along z, whose ends are exactly plane, and a point inside.
std::vector<Vec3> prism(int corners) {
  std::vector<Vec3> points{{0.1, 0.2, 0.3}};
  for (int i = 0; i < corners; ++i)
    for (const double z : {0.0, 1.0}) {
      const double angle = 2.0 * std::numbers::pi * i / corners;
      points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  return points;
}

RC_GTEST_PROP(ConvexHull, does_not_depend_on_the_order_of_points, ()) {
  std::vector<Vec3> points = prism(*rc::gen::inRange(3, 40));
  const mesh::TriangleMesh expected = convex_hull(points);
  for (std::size_t i = points.size() - 1; i > 0; --i)
    std::swap(points[i], points[*rc::gen::inRange<std::size_t>(0, i + 1)]);
  const mesh::TriangleMesh m = convex_hull(points);
  RC_ASSERT(m.positions == expected.positions);
  RC_ASSERT(m.triangles == expected.triangles);
}

TEST(ConvexHull, of_a_prism_has_its_corners_and_volume) {
  for (const int n : {3, 4, 7, 64}) {
    const mesh::TriangleMesh m = convex_hull(prism(n));
    EXPECT_EQ(m.positions.size(), 2u * n);
    EXPECT_EQ(m.triangles.size(), 4u * n - 4u);
    const double area = 0.5 * n * std::sin(2.0 * std::numbers::pi / n);
    EXPECT_NEAR(enclosed_volume_exact(m), area, 1e-14);  // outward: positive
    EXPECT_TRUE(std::is_sorted(m.triangles.begin(), m.triangles.end()));
  }
}

/// Many points of the triangle, the nearest of them.
RC_GTEST_PROP(Hausdorff, distance_to_a_triangle_is_that_to_its_nearest_point, ()) {
  const Vec3 x = *battery::point(2.0), a = *battery::point(1.0), b = *battery::point(1.0),
             c = *battery::point(1.0);
  constexpr int n = 60;
  double nearest = INFINITY;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      nearest = std::min(nearest, (a + (b - a) * i / n + (c - a) * j / n - x).norm());
  const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
  const double d = distance_to_triangle(x, a, b, c);
  RC_ASSERT(d <= nearest + 1e-12);
  RC_ASSERT(d >= nearest - longest / n);
}

TEST(Hausdorff, of_a_bump_is_its_height_seen_from_it_and_less_seen_from_the_plane) {
  const auto flat = battery::flat_rock(1.0, 0.0, 10);
  auto bump = battery::flat_rock(1.0, 0.0, 40);
  for (Vec3& x : bump.positions)
    if (x.head<2>().norm() < 1e-9) x.z() = -0.03;
  const HausdorffSampling sampling{0.01, 0.9};
  EXPECT_NEAR(one_sided_hausdorff(bump, flat, sampling), 0.03, 1e-12);
  const double back = one_sided_hausdorff(flat, bump, sampling);  // to the bump's flank
  EXPECT_LT(back, 0.029);
  EXPECT_GT(back, 0.01);
  EXPECT_NEAR(hausdorff(flat, bump, sampling), 0.03, 1e-12);
}

TEST(Hausdorff, of_equal_planes_in_other_triangles_is_nothing) {
  EXPECT_LT(
      hausdorff(battery::flat_rock(1.0, 0.2, 3), battery::flat_rock(1.0, 0.2, 17), {0.02, 0.9}),
      1e-15);
}

using Pairs = std::vector<std::pair<int, int>>;

/// Two triangles without a common vertex; the second one pierces the first, or stays above it.
TriangleMesh two_triangles(double lowest) {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, lowest}, {2, 1, 2}, {1, 2, 2}},
          {{0, 1, 2}, {3, 4, 5}}};
}

TEST(SelfIntersections, finds_the_piercing_pair_and_no_other) {
  EXPECT_EQ(self_intersections(two_triangles(-1.0)), (Pairs{{0, 1}}));
  EXPECT_EQ(self_intersections(two_triangles(1.0)), Pairs{});
}

TEST(SelfIntersections, touching_without_a_common_vertex_counts) {
  EXPECT_EQ(self_intersecting_pairs(two_triangles(0.0)), 1u);
}

/// The inner vertex of a flat rock leaves its ring sideways: triangles fold over each other.
TEST(SelfIntersections, finds_a_fold) {
  TriangleMesh m = battery::flat_rock(1.0, 0.0, 2);
  EXPECT_EQ(self_intersecting_pairs(m), 0u);
  m.positions[4] = Vec3(3, 0.5, 0);
  EXPECT_GT(self_intersecting_pairs(m), 0u);
}

TEST(SelfIntersections, rejects_what_is_not_an_oriented_manifold) {
  TriangleMesh m = two_triangles(1.0);
  m.triangles.push_back({0, 1, 3});
  EXPECT_THROW(self_intersections(m), RunError);
}

RC_GTEST_PROP(SelfIntersections, star_shapes_have_none, ()) {
  RC_ASSERT(self_intersecting_pairs(*battery::star_shape()) == 0u);
}

}  // namespace tdbd::reference::exact_volume_test

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/search/triangle_tree.hpp"
#include "reference/mesh/hausdorff.hpp"
#include "reference/rock/brute_force_exit.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::inside_test {

const TriangleMesh unit_box = battery::box({-1, -1, -1}, {1, 1, 1});

RC_GTEST_PROP(InsideTree, agrees_with_the_winding_number, ()) {
  const TriangleMesh part = *battery::star_shape();
  const Vec3 x = *battery::point(0.9);
  const TriangleTree tree(part);
  RC_PRE(distance(tree, x) > 1e-9);
  RC_ASSERT(inside(tree, x) == reference::inside(part, x));
}

/// Boxes nested in each other's corners: rays hit edges and diagonals all the time.
RC_GTEST_PROP(InsideTree, has_no_special_positions_in_a_box, ()) {
  const TriangleTree tree(unit_box);
  const auto coordinate = rc::gen::element(-1.5, -0.5, 0.0, 0.25, 0.5, 1.5);
  const Vec3 x(*coordinate, *coordinate, *coordinate);
  RC_ASSERT(inside(tree, x) == (x.cwiseAbs().maxCoeff() < 1.0));
}

/// The rays of triangle_tree.cpp.
const Vec3 rays[] = {{0.1237, 0.2711, 0.9545},   {-0.3319, 0.1173, 0.9360},
                     {0.2113, -0.4391, -0.8732}, {0.7713, 0.5381, 0.3394},
                     {-0.6151, 0.7333, -0.2895}, {0.3917, -0.9017, 0.1833}};

TEST(InsideTree, tries_another_ray_near_an_edge) {
  const TriangleTree tree(unit_box);
  for (const Vec3& rim : {Vec3(1, 1, 1), Vec3(1, 1, 0.25), Vec3(0.5, 0.5, 1), Vec3(1, 0, 1)})
    for (const Vec3& ray : rays)
      for (const double s : {-0.5, 0.25, 0.5, 1.5}) {
        const Vec3 x = rim - s * ray;
        EXPECT_EQ(inside(tree, x), x.cwiseAbs().maxCoeff() < 1.0) << x.transpose();
      }
}

/// A ball with a vertex on every ray from its centre.
TriangleMesh ball_on_rays(double radius) {
  TriangleMesh ball = battery::sphere(1.0, 2);
  for (const Vec3& ray : rays)
    *std::min_element(ball.positions.begin(), ball.positions.end(),
                      [&](const Vec3& a, const Vec3& b) { return a.dot(ray) > b.dot(ray); }) =
        ray.normalized();
  for (Vec3& x : ball.positions) x *= radius;
  return ball;
}

TEST(InsideTree, uses_the_winding_number_if_all_rays_hit_edges) {
  for (const double radius : {1e-3, 1.0, 20.0})
    EXPECT_TRUE(inside(TriangleTree(ball_on_rays(radius)), {0, 0, 0})) << radius;
}

/// A hollow ball, its inner surface turned over: the middle is outside.
TEST(InsideTree, recognises_a_hollow_by_its_winding_number) {
  for (const double radius : {1e-3, 0.5, 19.0}) {
    TriangleMesh hollow = ball_on_rays(20.0);
    const TriangleMesh inner = ball_on_rays(radius);
    const int first = static_cast<int>(hollow.positions.size());
    hollow.positions.insert(hollow.positions.end(), inner.positions.begin(), inner.positions.end());
    for (const Triangle& t : inner.triangles)
      hollow.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    EXPECT_FALSE(inside(TriangleTree(hollow), {0, 0, 0})) << radius;
  }
}

RC_GTEST_PROP(SquaredDistance, does_not_depend_on_the_first_corner, ()) {
  const Facet f{*battery::point(1.0), *battery::point(1.0), *battery::point(1.0)};
  const Vec3 x = *battery::point(1.0);
  const double d = squared_distance(f, x);
  RC_ASSERT(std::abs(squared_distance({f.b, f.c, f.a}, x) - d) < 1e-12);
  RC_ASSERT(d <= std::min({(x - f.a).squaredNorm(), (x - f.b).squaredNorm(),
                           (x - 0.5 * (f.b + f.c)).squaredNorm()}) +
                     1e-15);
}

TEST(InsideTree, nothing_is_inside_an_empty_mesh) {
  EXPECT_FALSE(inside(TriangleTree{}, {0, 0, 0}));
}

RC_GTEST_PROP(DistanceTree, of_a_box_is_its_closed_form, ()) {
  const TriangleTree tree(unit_box);
  const Vec3 x = *battery::point(2.0);
  const Vec3 over = x.cwiseAbs() - Vec3::Ones();
  const double expected = over.maxCoeff() > 0.0 ? over.cwiseMax(0.0).norm() : -over.maxCoeff();
  RC_ASSERT(std::abs(distance(tree, x) - expected) < 1e-14);
  RC_ASSERT(is_near(tree, x, expected + 1e-9));
  RC_ASSERT(!is_near(tree, x, expected - 1e-9) || expected < 1e-9);
}

/// No facet is missed: the nearest of all facets, one by one.
RC_GTEST_PROP(DistanceTree, is_the_least_over_all_facets, ()) {
  const TriangleTree tree(*battery::star_shape());
  const Vec3 x = *battery::point(2.0);
  double least = 1e300;
  for (const Facet& f : tree.facets()) least = std::min(least, squared_distance(f, x));
  RC_ASSERT(tree.facets().size() == 80u);
  RC_ASSERT(std::abs(distance(tree, x) - std::sqrt(least)) < 1e-14);
}

TriangleMesh bumpy(int divisions, double height) {
  return battery::bumpy_rock(1.0, divisions, height,
                             static_cast<std::uint64_t>(*battery::integer(0, 1000)));
}

/// Both sample from below to within their spacing.
RC_GTEST_PROP(SurfaceDistance, is_that_of_the_slow_twin, ()) {
  const TriangleMesh from = bumpy(*battery::integer(2, 12), 0.2);
  const TriangleMesh to = bumpy(*battery::integer(2, 12), 0.2);
  const double spacing = *battery::number(0.02, 0.1);
  const SurfaceDistance found = distance_to(from, TriangleTree(to), spacing);
  const double twin = reference::one_sided_hausdorff(from, to, {spacing, 2.0});
  RC_ASSERT(std::abs(found.largest - twin) <= spacing);
  RC_ASSERT(found.volume <= area(from) * found.largest);
}

/// The nearest facet of each corner, one facet after the other.
RC_GTEST_PROP(SurfaceDistance, at_corners_is_that_to_the_nearest_facet, ()) {
  const TriangleMesh from = bumpy(3, 0.3), to = bumpy(5, 0.3);
  double largest = 0.0;
  for (const Vec3& x : from.positions) {
    double least = INFINITY;
    for (const auto& [a, b, c] : to.triangles)
      least =
          std::min(least, reference::distance_to_triangle(
                              x, to.positions[at(a)], to.positions[at(b)], to.positions[at(c)]));
    largest = std::max(largest, least);
  }
  constexpr double rounding = 1e-14, no_finer = 100.0;
  RC_ASSERT(distance_to(from, TriangleTree(to), no_finer).largest >= largest - rounding);
}

TEST(SurfaceDistance, of_parallel_planes_is_exact) {
  const TriangleMesh low = battery::flat_rock(1.0, 0.0, 7);
  const TriangleMesh high = battery::flat_rock(1.0, -0.25, 3);
  const SurfaceDistance d = distance_to(low, TriangleTree(high), 0.05);
  EXPECT_DOUBLE_EQ(d.largest, 0.25);
  EXPECT_NEAR(d.volume, 4.0 * 0.25, 1e-13);
}

/// A tent of height h over a square of side 2: its distance to the square is z, of mean h / 3. Whichever corner its facets
/// begin with.
TEST(SurfaceDistance, integral_over_a_tent_is_exact) {
  const double h = 0.1;
  const TriangleMesh ground = battery::flat_rock(3.0, 0.0, 1);
  TriangleMesh tent;
  tent.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, -h}};
  tent.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const double area = 4.0 * std::sqrt(1.0 + h * h);
  for (int first = 0; first < 3; ++first) {
    for (Triangle& t : tent.triangles) t = {t[1], t[2], t[0]};
    const SurfaceDistance d = distance_to(tent, TriangleTree(ground), 0.5);
    EXPECT_NEAR(d.volume, area * h / 3.0, 1e-14);  // z is linear: middles of parts are exact
    EXPECT_DOUBLE_EQ(d.largest, h);
  }
}

TEST(SurfaceDistance, of_nothing_is_zero) {
  const SurfaceDistance d = distance_to({}, TriangleTree(battery::flat_rock(1.0, 0.0, 1)), 0.1);
  EXPECT_EQ(d.largest, 0.0);
  EXPECT_EQ(d.volume, 0.0);
}

}  // namespace tdbd::mesh::inside_test

#include "mesh/search/surface_distance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "reference/mesh/hausdorff.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::surface_distance_test {

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

}  // namespace tdbd::mesh::surface_distance_test

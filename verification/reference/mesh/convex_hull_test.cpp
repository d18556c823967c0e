#include "reference/mesh/convex_hull.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/mesh/exact_volume.hpp"

namespace tdbd::reference::convex_hull_test {

/// The corners of a prism along z, whose ends are plane to the bit, and a point within.
std::vector<Vec3> prism(int corners) {
  std::vector<Vec3> points{{0.1, 0.2, 0.3}};
  for (int i = 0; i < corners; ++i)
    for (const double z : {0.0, 1.0}) {
      const double angle = 2.0 * std::numbers::pi * i / corners;
      points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  return points;
}

RC_GTEST_PROP(ConvexHull, does_not_hang_on_the_order_of_points, ()) {
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

}  // namespace tdbd::reference::convex_hull_test

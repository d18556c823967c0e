#include "reference/mesh/hausdorff.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::hausdorff_test {

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

}  // namespace tdbd::reference::hausdorff_test

#include "bit/surface_of_revolution.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::surface_of_revolution_test {

/// A solid of revolution with any number of points on each of its rings.
RC_GTEST_PROP(SurfaceOfRevolution, is_closed_and_oriented_for_any_counts, ()) {
  std::vector<Ring> rings{{0.0, 1.0, 1}};
  const int n = *rc::gen::inRange(1, 6);
  for (int k = 0; k < n; ++k)
    rings.push_back({number(0.5, 1.5), 1.0 - (k + 1.0) / (n + 1), *rc::gen::inRange(3, 40)});
  rings.push_back({0.0, 0.0, 1});
  const mesh::TriangleMesh m = surface_of_revolution(rings);
  RC_ASSERT(is_closed_and_oriented(m));
  RC_ASSERT(mesh::enclosed_volume(m) > 0.0);
}

/// Two polygons of n points with their plane of symmetry: a double cone's volume is closed-form.
RC_GTEST_PROP(SurfaceOfRevolution, of_two_cones_has_their_volume, ()) {
  const int n = *rc::gen::inRange(3, 100);
  const double r = number(0.1, 2.0), h = number(0.1, 2.0);
  const mesh::TriangleMesh m = surface_of_revolution({{0, h, 1}, {r, 0, n}, {0, -h, 1}});
  const double base = 0.5 * n * r * r * std::sin(2 * pi / n);
  RC_ASSERT(std::abs(mesh::enclosed_volume(m) - 2.0 * base * h / 3.0) < 1e-14 * base * h + 1e-16);
}

TEST(SurfaceOfRevolution, starts_every_ring_at_minus_z) {
  const mesh::TriangleMesh m = surface_of_revolution({{0, 1, 1}, {2, 0.5, 7}, {0, 0, 1}});
  EXPECT_EQ(m.positions[1], Vec3(0.5, 0.0, -2.0));
  EXPECT_GT(m.positions[2].y(), 0.0);
}

}  // namespace tdbd::bit::surface_of_revolution_test

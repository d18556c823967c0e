#include "mesh/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tdbd::mesh {
namespace {

TEST(Measures, quality_is_one_for_equilateral_and_zero_for_degenerate) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0.5, std::sqrt(0.75), 0);
  EXPECT_NEAR(triangle_quality(a, b, c), 1.0, 1e-15);
  EXPECT_EQ(triangle_quality(a, b, Vec3(0.3, 0, 0)), 0.0);
  EXPECT_EQ(triangle_quality(a, a, a), 0.0);
}

TEST(Measures, volume_of_a_tetrahedron_far_from_the_origin_is_exact) {
  TriangleMesh m{{{8, 8, 8}, {9, 8, 8}, {8, 9, 8}, {8, 8, 9}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_DOUBLE_EQ(enclosed_volume(m), 1.0 / 6.0);
  EXPECT_NEAR(area(m), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
}

}  // namespace
}  // namespace tdbd::mesh

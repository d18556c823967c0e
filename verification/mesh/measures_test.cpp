#include "mesh/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/surface.hpp"

namespace tdbd::mesh::measures_test {

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

/// A fan of thinner and thinner triangles about the origin.
TEST(Measures, quality_figures_are_the_worst_and_the_one_that_99_percent_exceed) {
  TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  double angle = 0.0;
  for (int i = 0; i <= 250; ++i) {
    m.positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0.0));
    angle += 0.02 / (i + 1);
    if (i > 0) m.triangles.push_back({0, i, i + 1});
  }
  std::vector<double> q;
  for (const auto& [a, b, c] : m.triangles)
    q.push_back(triangle_quality(m.positions[at(a)], m.positions[at(b)], m.positions[at(c)]));
  const QualityFigures found = quality_figures(m), of_surface = quality_figures(make_surface(m));
  EXPECT_EQ(found.least, q.back());
  EXPECT_EQ(found.one_percent, q[q.size() - 3]);
  EXPECT_EQ(of_surface.least, found.least);
  EXPECT_EQ(of_surface.one_percent, found.one_percent);
  EXPECT_EQ(quality_figures(TriangleMesh{}).least, 0.0);
}

}  // namespace tdbd::mesh::measures_test

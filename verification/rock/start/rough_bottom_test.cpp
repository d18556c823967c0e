#include "rock/start/rough_bottom.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rock/start/borehole.hpp"

namespace tdbd::rock::rough_bottom_test {

const Roughness rough{2e-3, 10e-3, 11};

mesh::TriangleMesh bottom(const Roughness& r) {
  mesh::TriangleMesh m = borehole(flat_bottom(0.1, 0.02, 0.03), 0.005);
  roughen_bottom(m, r);
  return m;
}

/// Mean over surfaces of seeds 1 to n of the product of heights at distance d, over amplitude^2.
double correlation(double d, int n) {
  double sum = 0.0;
  for (int seed = 1; seed <= n; ++seed) {
    const Roughness r{rough.amplitude, rough.correlation_length, static_cast<std::uint64_t>(seed)};
    const std::vector<Wave> waves = rough_waves(r);
    sum += roughness_at(r, waves, 0.01, 0.02) * roughness_at(r, waves, 0.01 + d, 0.02);
  }
  return sum / n / (rough.amplitude * rough.amplitude);
}

/// Of n independent products the mean strays by sqrt((1 + rho^2) / n), n = 4000: 0.022.
TEST(RoughBottom, has_its_amplitude_and_correlation) {
  for (const double over : {0.0, 0.5, 1.0, 2.0})
    EXPECT_NEAR(correlation(over * rough.correlation_length, 4000), std::exp(-0.5 * over * over),
                0.045)
        << over;
}

TEST(RoughBottom, is_the_same_for_the_same_seed) {
  EXPECT_TRUE(bottom(rough).positions == bottom(rough).positions);
  EXPECT_FALSE(bottom(rough).positions == bottom({2e-3, 10e-3, 12}).positions);
}

TEST(RoughBottom, goes_down_from_the_flat_one_and_leaves_the_rim) {
  const mesh::TriangleMesh flat = borehole(flat_bottom(0.1, 0.02, 0.03), 0.005), m = bottom(rough);
  double least = 1.0, most = 0.0;
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const Vec3 way = m.positions[v] - flat.positions[v];
    EXPECT_EQ(way.head<2>(), Eigen::Vector2d::Zero());
    if (flat.positions[v].z() == -0.01) {
      EXPECT_EQ(way.z(), 0.0);
    }
    if (flat.positions[v].z() < 0.02) continue;
    least = std::min(least, way.z());
    most = std::max(most, way.z());
  }
  EXPECT_EQ(least, 0.0);
  EXPECT_GT(most, 4.0 * rough.amplitude);
}

}  // namespace tdbd::rock::rough_bottom_test

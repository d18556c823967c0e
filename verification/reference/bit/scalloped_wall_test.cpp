#include "reference/bit/scalloped_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/battery/shapes.hpp"

namespace tdbd::reference::scalloped_wall_test {

constexpr double pi = std::numbers::pi;
constexpr double a = 8e-3, middle = 0.05, advance = 2e-3;  // m

/// Thin discs in half-planes of the axis, so many at equal angles.
bit::Bit discs(int count) {
  bit::Bit bit;
  for (int i = 0; i < count; ++i) {
    const Mat3 turned =
        Eigen::AngleAxisd(0.7 + 2.0 * pi * i / count, Vec3::UnitZ()).toRotationMatrix();
    bit::Part part;
    part.X_BP.R.col(0) = turned * Vec3::UnitX();
    part.X_BP.R.col(1) = Vec3::UnitZ();
    part.X_BP.R.col(2) = -(turned * Vec3::UnitY());
    part.X_BP.p = turned * Vec3(middle, 0, 0);
    part.mesh_P = battery::cylinder(a, 1e-7, 256);
    bit.parts.push_back(part);
  }
  return bit;
}

/// Of a disc that passes every `pitch`: pi times the mean of (R + sqrt(a^2 - z^2))^2.
double volume(double pitch) {
  double sum = 0.0;
  constexpr int parts = 10000;
  for (int i = 0; i < parts; ++i) {
    const double z = pitch * ((i + 0.5) / parts - 0.5);
    sum += std::pow(middle + std::sqrt(a * a - z * z), 2) / parts;
  }
  return pi * advance * sum;
}

/// Three discs at equal angles pass every third of the advance: their scallops are a ninth as deep.
TEST(ScallopedWall, of_discs_is_their_arcs_side_by_side) {
  for (const int count : {1, 3}) {
    const ScallopedWall wall = scalloped_wall(discs(count), advance, 1000);
    const double pitch = advance / count;
    EXPECT_NEAR(wall.reach, middle + a, 1e-12);
    EXPECT_NEAR(wall.volume, volume(pitch), 3e-5 * wall.volume);
    const double cusp = middle + std::sqrt(a * a - 0.25 * pitch * pitch);
    EXPECT_NEAR(*std::ranges::min_element(wall.radius), cusp, 1.4e-6);
  }
}

}  // namespace tdbd::reference::scalloped_wall_test

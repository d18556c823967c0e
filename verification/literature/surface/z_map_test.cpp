#include "reference/literature/surface/z_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/bit/radial_plane_engagement.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::z_map_test {

constexpr double pi = std::numbers::pi;

Pose at(double x, double y, double z) { return {Mat3::Identity(), Vec3(x, y, z)}; }

TEST(ZMap, a_box_leaves_its_shape) {
  ZMap rock = flat_z_map(2.0, 0.0, 40);
  const auto cube = battery::box({-1, -1, -1}, {1, 1, 1});
  EXPECT_NEAR(cut(rock, cube, at(0, 0, -0.75)), 1.0, 1e-12);
  EXPECT_EQ(cut(rock, cube, at(0, 0, -0.75)), 0.0);
  EXPECT_NEAR(*std::max_element(rock.height.begin(), rock.height.end()), 0.25, 1e-15);
}

TEST(ZMap, a_part_in_the_air_or_beside_the_map_removes_nothing) {
  ZMap rock = flat_z_map(2.0, 0.0, 10);
  const auto cube = battery::box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(cut(rock, cube, at(0, 0, -1.5)), 0.0);
  EXPECT_EQ(cut(rock, cube, at(9, -9, 0)), 0.0);
}

TEST(ZMap, a_ball_pressed_in_removes_its_cap) {
  ZMap rock = flat_z_map(1.1, 0.0, 220);
  const double h = 0.4, cap = pi * h * h * (1.0 - h / 3.0);
  EXPECT_NEAR(cut(rock, battery::sphere(1.0, 5), at(0, 0, h - 1.0)), cap, 3e-3 * cap);
}

/// A small bit of three discs that face along their paths, drilling at constant advance.
bit::Bit three_discs() {
  const Mat3 z_to_y = Eigen::AngleAxisd(-pi / 2, Vec3::UnitX()).toRotationMatrix();
  bit::Bit bit;
  for (const auto& [radius, azimuth, z] :
       std::array{std::array{4e-3, 0.3, 0.0}, std::array{6e-3, 2.0, -2e-4},
                  std::array{8e-3, 5.0, -4e-4}}) {
    const Mat3 turned = Eigen::AngleAxisd(azimuth, Vec3::UnitZ()).toRotationMatrix();
    bit::Part part;
    part.X_BP = {turned * z_to_y, turned * Vec3(radius, 0, z)};
    part.mesh_P = battery::cylinder(4e-3, 2e-4, 64);
    part.cutter = static_cast<int>(bit.cutters.size());
    bit.parts.push_back(part);
    bit.cutters.push_back({});
    bit.cutters.back().azimuth = azimuth;
  }
  return bit;
}

/// The height field and the radial plane know nothing of each other: one moves the bit in time, the
/// other sorts passes. They must agree cutter by cutter, so the sense of rotation and the order of
/// the cutters are right in both.
TEST(ZMap, removes_by_cutter_what_the_radial_plane_predicts) {
  const bit::Bit bit = three_discs();
  const double advance = 1e-3;
  const int steps = 1200, revolutions = 3;
  ZMap rock = flat_z_map(13e-3, 0.0, 260);
  std::vector<double> removed(bit.cutters.size());
  for (int i = -2 * steps; i < revolutions * steps; ++i) {
    if (i == (revolutions - 1) * steps) std::fill(removed.begin(), removed.end(), 0.0);
    const double turns = static_cast<double>(i) / steps;
    const Mat3 R = Eigen::AngleAxisd(2.0 * pi * turns, Vec3::UnitZ()).toRotationMatrix();
    const Pose X_WB{R, Vec3(0, 0, advance * turns - 2e-3)};
    for (const bit::Part& part : bit.parts)
      removed[part.cutter] += cut(rock, part.mesh_P, X_WB * part.X_BP);
  }
  const Engagement e = radial_plane_engagement(bit, advance, 2e-5);
  for (std::size_t c = 0; c < removed.size(); ++c)
    EXPECT_NEAR(removed[c], e.volume_per_revolution[c], 0.01 * e.total) << "cutter " << c;
}

}  // namespace tdbd::reference::z_map_test

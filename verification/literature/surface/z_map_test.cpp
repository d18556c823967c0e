#include "reference/literature/surface/z_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/bit/radial_plane_engagement.hpp"
#include "reference/literature/surface/sweep_tool.hpp"
#include "reference/literature/surface/z_map_sweep.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
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

double most_apart(const ZMap& a, const ZMap& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.height.size(); ++i)
    most = std::max(most, std::abs(a.height[i] - b.height[i]));
  return most;
}

/// A cell whose centre lies on a facet's rim to rounding may belong to one and not the other: at a
/// silhouette this decides about a whole depth. It is rare for positions that are no multiples of
/// the cell size and does not occur here.
RC_GTEST_PROP(ZMapSweep, takes_row_by_row_what_the_slow_twin_takes, ()) {
  const mesh::TriangleMesh part = *battery::convex_polyhedron();
  Pose X_WP = *battery::pose(0.3);
  X_WP.p += Vec3(0.01234567, 0.0234567, -0.2);
  ZMap slow = flat_z_map(1.7, 0.0, 67), quick = slow;
  const double removed = cut(slow, part, X_WP);
  RC_ASSERT(std::abs(cut_sweep(quick, part, X_WP) - removed) < 1e-12);
  RC_ASSERT(most_apart(slow, quick) < 1e-12);
}

TEST(ZMapSweep, of_a_sheet_has_its_heights) {
  const mesh::TriangleMesh sheet =
      battery::placed({Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix(), Vec3::Zero()},
                      battery::flat_rock(1.0, 0.0, 7));
  const ZMap map = z_map_of(sheet, 0.8, 33);
  for (const double y : {-0.77, -0.3, 0.01, 0.5})  // a plane: bilinear is exact
    EXPECT_NEAR(height_at(map, 0.123, y), y * std::tan(0.3), 1e-12);
}

/// Heights at corners of cells are means of four: exact for planes, off by a cell's share of a
/// curved surface, which order 2 shows.
TEST(ZMapSweep, height_between_cells_converges_with_order_two) {
  const auto error = [](int cells) {
    ZMap map = flat_z_map(1.0, 0.0, cells);
    for (int i = 0; i < cells * cells; ++i) {
      const double x = -1.0 + (i % cells + 0.5) * map.cell();
      map.height[static_cast<std::size_t>(i)] = x * x;
    }
    double worst = 0.0;
    for (double x = -0.8; x < 0.8; x += 0.0137)
      worst = std::max(worst, std::abs(height_at(map, x, 0.1) - x * x));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(32) / error(64)), 2.0, 2.2e-4);
}

}  // namespace tdbd::reference::z_map_test

namespace tdbd::reference::sweep_tool_test {

/// A disc of 6 mm, 0.1 mm thick, 10 mm from the axis; faces along its path, tip straight down.
bit::Bit one_disc() {
  bit::Part part;
  part.mesh_P = battery::cylinder(3e-3, 1e-4, 48);
  part.cutter = 0;
  part.X_BP.R.col(0) = Vec3::UnitX();
  part.X_BP.R.col(1) = Vec3::UnitZ();
  part.X_BP.R.col(2) = -Vec3::UnitY();
  part.X_BP.p = Vec3(10e-3, 0, 0);
  bit::Bit bit;
  bit.parts = {part};
  bit.cutters.resize(1);
  bit.cutters[0].X_BC.R.col(0) = Vec3::UnitY();   // X along the path
  bit.cutters[0].X_BC.R.col(1) = Vec3::UnitX();   // Y outwards
  bit.cutters[0].X_BC.R.col(2) = -Vec3::UnitZ();  // Z out of the rock
  bit.cutters[0].X_BC.p = part.X_BP.p;
  return bit;
}

Pose screw(double turn) {
  return {Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix(),
          Vec3(0, 0, 1e-3 * turn / (2.0 * std::numbers::pi))};
}

constexpr double step = 2.0 * std::numbers::pi / 200;

double volume_of_a_turn(double reach, double start) {
  const auto tools =
      sweep_tools(cutter_hulls(one_disc()), inverse(screw(step)) * screw(0.0), reach);
  ZMap rock = flat_z_map(14e-3, start, 280);
  double removed = 0.0;
  for (int i = 1; i <= 200; ++i) removed += cut_sweep(rock, tools, screw(step * i));
  return removed;
}

/// Rock from 1 mm above the tip on: facets farther than 2.5 mm from it cannot reach it.
TEST(SweepTool, facets_out_of_reach_of_the_cut_take_nothing) {
  const double start = 2e-3;
  EXPECT_DOUBLE_EQ(volume_of_a_turn(2.5e-3, start), volume_of_a_turn(1.0, start));
  EXPECT_LT(volume_of_a_turn(0.1e-3, start), 0.9 * volume_of_a_turn(1.0, start));
}

/// The hull joins both ends of the step, so a turn of few steps leaves no gaps: the groove's volume
/// is the segment of the disc on its way about the axis, a spiral ramp of 1 mm deep at its end.
TEST(SweepTool, a_turn_removes_the_segment_times_its_way) {
  const double a = 3e-3, y0 = 2e-3;  // the chord's height at the start
  const auto segment = [a](double y) {
    return a * a * std::acos(y / a) - y * std::sqrt(a * a - y * y);
  };
  double swept = 0.0;
  constexpr int parts = 1000;
  for (int i = 0; i < parts; ++i)
    swept += segment(y0 - 1e-3 * (i + 0.5) / parts) * 2.0 * std::numbers::pi * 10e-3 / parts;
  EXPECT_NEAR(volume_of_a_turn(1.0, y0), swept, 0.01 * swept);
}

/// A disc goes straight down and ahead: both kinds of tool sweep the same.
TEST(SweepTool, ruled_tools_sweep_a_translation_like_the_hull) {
  const auto hulls = cutter_hulls(one_disc());
  const Pose back{Mat3::Identity(), Vec3(0.31e-3, -1.7e-3, -0.9e-3)},
      at{Mat3::Identity(), Vec3::Zero()};
  ZMap hull = flat_z_map(14e-3, 1e-3, 300), ruled = hull;
  const double removed = cut_sweep(hull, sweep_tools(hulls, back, 1.0), at);
  EXPECT_GT(removed, 0.0);
  EXPECT_NEAR(cut_sweep(ruled, ruled_tools(hulls, back), at), removed, 1e-12 * removed);
}

/// With a turn they differ by its square.
TEST(SweepTool, ruled_tools_sweep_a_turn_like_the_hull_to_second_order) {
  const auto hulls = cutter_hulls(one_disc());
  const auto difference = [&](double turn) {
    ZMap hull = flat_z_map(14e-3, 1e-3, 300), ruled = hull;
    cut_sweep(hull, sweep_tools(hulls, screw(-turn), 1.0), screw(0.0));
    cut_sweep(ruled, ruled_tools(hulls, screw(-turn)), screw(0.0));
    double most = 0.0;
    for (std::size_t i = 0; i < hull.height.size(); ++i)
      most = std::max(most, std::abs(hull.height[i] - ruled.height[i]));
    return most;
  };
  // m, times the turn squared.
  EXPECT_LE(difference(0.1), 1.8e-3 * 0.1 * 0.1);
  EXPECT_LE(difference(0.02), 5e-3 * 0.02 * 0.02);
}

}  // namespace tdbd::reference::sweep_tool_test

#include "reference/literature/surface/sweep_tool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/literature/surface/z_map_sweep.hpp"
#include "verification/battery/shapes.hpp"

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

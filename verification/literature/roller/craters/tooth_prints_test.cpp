#include "reference/literature/roller/craters/tooth_prints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::tooth_prints_test {
namespace {

const ToothLaw law = example::power_tooth();

ZMap flat() { return flat_z_map(15e-3, 0.0, 150); }

/// Presses a tooth at (x, 0) to a depth; the bottom under it is the flat one until it leaves.
double press(ToothPrint& print, const PrintOptions& options, double x, double depth, ZMap& bottom,
             PrintVolumes& volumes) {
  return follow_print(print, law, options, Vec3(x, 0.0, depth), depth, bottom, volumes);
}

TEST(ToothPrints, leave_one_crater_of_the_deepest_place_when_the_tooth_is_out) {
  ZMap bottom = flat();
  ToothPrint print;
  PrintVolumes volumes;
  const PrintOptions options;
  for (const double depth : {0.5e-3, 1e-3, 0.6e-3})
    EXPECT_EQ(press(print, options, depth, depth, bottom, volumes), 0.0);
  EXPECT_EQ(print.deepest, 1e-3);
  const double r = crater_radius(law, 1e-3), cone = std::numbers::pi * r * r * 1e-3 / 3.0;
  EXPECT_NEAR(press(print, options, 2e-3, -1e-6, bottom, volumes), cone, 2e-3 * cone);
  EXPECT_NEAR(volumes.isolated, cone, 1e-12 * cone);
  EXPECT_NEAR(level_at(bottom, 1e-3, 0.0), 1e-3, 0.05e-3);
  EXPECT_EQ(print.deepest, 0.0);
  EXPECT_EQ(press(print, options, 2e-3, -1e-6, bottom, volumes), 0.0);
}

/// A ball dragged through the rock leaves a groove, and behind itself at once.
TEST(ToothPrints, sweep_a_groove_behind_the_tooth) {
  ZMap bottom = flat();
  ToothPrint print;
  PrintVolumes volumes;
  const PrintOptions options{
      .path = PrintPath::swept, .shape = CraterShape::sphere, .sphere_radius = 6e-3};
  constexpr double depth = 1e-3, way = 10e-3;
  for (double x = -5e-3; x < 5e-3; x += 0.05e-3) press(print, options, x, depth, bottom, volumes);
  EXPECT_NEAR(level_at(bottom, -2e-3, 0.0), depth, 0.02e-3);
  EXPECT_LT(level_at(bottom, 5e-3, 0.0), 0.01e-3);
  press(print, options, 5e-3, -1e-6, bottom, volumes);
  const double a = options.sphere_radius, half = std::acos(1.0 - depth / a);
  const double section = a * a * (half - std::sin(half) * std::cos(half));
  const double cap = std::numbers::pi * depth * depth * (a - depth / 3.0);
  EXPECT_NEAR(volumes.dug, way * section + cap, 0.01 * volumes.dug);
  EXPECT_NEAR(volumes.isolated, cap, 1e-12 * cap);
}

TEST(ToothPrints, of_crushed_rock_do_not_spring_back) {
  PrintOptions options;
  ToothPrint print;
  print.deepest = 1e-3;
  options.release = ToothRelease::elastic;
  EXPECT_EQ(print_share(options, print, 0.5e-3), 1.0);
  options.release = ToothRelease::crushed;
  EXPECT_EQ(print_share(options, print, 1e-3), 1.0);
  EXPECT_NEAR(print_share(options, print, 1e-3 - 10e-6), 0.5, 1e-9);
  EXPECT_EQ(print_share(options, print, 0.9e-3), 0.0);
  EXPECT_EQ(print_share(options, print, 1.2e-3), 1.0);
  EXPECT_EQ(print_share(options, print, -1e-9), 0.0);
}

}  // namespace
}  // namespace tdbd::reference::tooth_prints_test

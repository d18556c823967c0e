#include "reference/literature/roller/craters/huang_cawthorne.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::huang_cawthorne_test {
namespace {

/// Rounding over 667 steps: rad/s, m.
constexpr double of_speeds = 7e-14, of_depths = 5e-17;

RollerSchedule schedule(double revolutions) {
  return {3.0 * std::numbers::pi, 20e3, 1e-3, revolutions, 0.5 * revolutions};
}

RollerRun run(PatentWay way, HuangCawthorneOptions options, double revolutions) {
  options.way = way;
  return huang_cawthorne(example::roller_bit(4e-3), example::tooth_table(), schedule(revolutions),
                         options);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Six teeth at given heights under 20 kN, by the worked table: depths, forces, craters.
TEST(HuangCawthorne, gives_the_worked_craters_of_six_teeth) {
  const ToothLaw law = example::tooth_table();
  constexpr std::array heights{0.0, 0.4e-3, 0.7e-3, 1.1e-3, 1.6e-3, 2.0e-3};
  const auto carried = [&](double z) {
    double sum = 0.0;
    for (const double h : heights) sum += tooth_force(law, z - h);
    return sum;
  };
  BalanceOptions options;
  options.tolerance = 1e-13;
  const double z = weight_balance(carried, 0.0, 20e3, options, "Huang and Cawthorne").z;
  EXPECT_NEAR(z, 1.4923077e-3, 0.6e-10);
  constexpr std::array forces{8938.46, 5738.46, 3753.85, 1569.23, 0.0, 0.0};
  constexpr std::array radii{3.48615, 2.76615, 2.14308, 1.17692, 0.0, 0.0};
  constexpr std::array volumes{18.9924, 8.7524, 3.8106, 0.5691, 0.0, 0.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double depth = z - heights[i], radius = crater_radius(law, depth);
    const double volume =
        1e9 * isolated_volume({Vec3::Zero(), std::max(depth, 0.0), radius, CraterShape::cone});
    EXPECT_NEAR(tooth_force(law, depth), forces[i], 6e-3) << i;
    EXPECT_NEAR(1e3 * radius, radii[i], 6e-6) << i;
    EXPECT_NEAR(volume, volumes[i], 6e-5) << i;
    sum += volume;
  }
  EXPECT_NEAR(sum, 32.1245, 6e-5);
}

/// Without bearing, averaging and a first turn of given ratios both ways are one recursion. Teeth that
/// let go within 20 um would make more of rounding.
TEST(HuangCawthorne, its_two_ways_are_one_when_they_see_the_same_torque) {
  HuangCawthorneOptions options;
  options.torque_average = 0.0;
  options.given_revolutions = 0.0;
  options.drilling.print.release = ToothRelease::elastic;
  const RollerRun a = run(PatentWay::first, options, 1.0), b = run(PatentWay::second, options, 1.0);
  EXPECT_LT(largest_difference(a.series.cone_speeds, b.series.cone_speeds), of_speeds);
  EXPECT_LT(largest_difference(a.series.depth, b.series.depth), of_depths);
}

TEST(HuangCawthorne, its_ways_part_by_what_is_in_the_torque) {
  HuangCawthorneOptions options;
  const RollerRun averaged = run(PatentWay::first, options, 4.0),
                  free = run(PatentWay::second, options, 4.0);
  options.torque_average = 0.0;
  const RollerRun at_once = run(PatentWay::first, options, 4.0);
  EXPECT_GT(largest_difference(averaged.series.cone_speeds, at_once.series.cone_speeds), 0.1);
  options.bearing = 20.0;
  const RollerRun bearing = run(PatentWay::second, options, 4.0);
  EXPECT_GT(largest_difference(averaged.series.cone_speeds, free.series.cone_speeds), 0.1);
  EXPECT_GT(largest_difference(bearing.series.cone_speeds, free.series.cone_speeds), 0.1);
  EXPECT_GT(bearing.torque, free.torque);
}

/// On its first turn the first way's cones turn at the ratio that they are given.
TEST(HuangCawthorne, begins_with_a_turn_of_given_ratios) {
  HuangCawthorneOptions options;
  options.first_ratio = 1.4;
  const RollerRun r = run(PatentWay::first, options, 2.0);
  const double given = -1.4 * 3.0 * std::numbers::pi;
  for (std::size_t i = 0; i < 600; ++i) EXPECT_NEAR(r.series.cone_speeds[3 * i], given, 1e-9);
  EXPECT_GT(std::abs(r.series.cone_speeds.back() - given), 0.1);
}

TEST(HuangCawthorne, refuses_a_table_that_is_not_monotone) {
  ToothTable table = example::tooth_table();
  table.force[4] = 8e3;
  try {
    huang_cawthorne(example::roller_bit(0.0), table, schedule(1.0));
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("Huang and Cawthorne: table of single-tooth tests: row 5: "
                                         "force: found 8000 after 9000"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace tdbd::reference::huang_cawthorne_test

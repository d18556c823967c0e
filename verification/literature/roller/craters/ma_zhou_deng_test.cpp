#include "reference/literature/roller/craters/ma_zhou_deng.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/craters/huang_cawthorne.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::ma_zhou_deng_test {

/// 90 rpm, 20 kN.
RollerSchedule schedule(double revolutions, double step) {
  return {3.0 * std::numbers::pi, 20e3, step, revolutions, 1.0};
}

/// Depths are found to 1e-9 m, and a tooth lets go of 10 kN within 20 um; scale: N.
constexpr double of_balance = 0.5;

RollerRun run(const RollerSchedule& s, const MaZhouDengOptions& options = {}) {
  return ma_zhou_deng(example::roller_bit(4e-3), example::power_tooth(), s, options);
}

std::string message_of(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& s) {
  try {
    ma_zhou_deng(bit, law, s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// Three upright teeth on flat rock carry a third of the weight each.
TEST(MaZhouDeng, is_as_deep_as_its_teeth_carry_the_weight) {
  RollerBit bit = example::roller_bit(0.0);
  for (RollerCone& cone : bit.cones) cone.rows = {example::even_row(80e-3, 60e-3, 1, 0.0)};
  RollerSchedule s = schedule(0.01, 1e-6);
  s.settle = 0.0;
  MaZhouDengOptions options;
  options.drilling.start = BottomStart::flat;
  const RollerRun r = ma_zhou_deng(bit, example::power_tooth(), s, options);
  const RollerCone& cone = bit.cones[0];
  const double lowest =
      -80e-3 * std::sin(cone.journal_angle) + 60e-3 * std::cos(cone.journal_angle);
  const double depth = std::pow(20.0 / 15.0, 2.0 / 3.0) * 1e-3;
  EXPECT_NEAR(r.series.depth[0] + lowest, depth, 2e-9);
  EXPECT_EQ(r.series.contacts[0], 3);
}

TEST(MaZhouDeng, carries_the_weight_in_every_step_and_rides_up_on_ridges) {
  const RollerRun r = run(schedule(3.0, 1e-3));
  for (const double weight : r.series.weight) EXPECT_NEAR(weight, 20e3, of_balance);
  int up = 0;
  for (std::size_t i = 1; i < r.series.depth.size(); ++i)
    if (r.series.depth[i] < r.series.depth[i - 1]) ++up;
  EXPECT_GT(up, 100);
  EXPECT_GT(r.rate, 0.0);
}

/// Rows that roll at 1.666 and 1.498 drag each other: the cone turns at a ratio between.
TEST(MaZhouDeng, turns_cones_between_the_rolling_ratios_of_their_rows) {
  const RollerRun r = run(schedule(4.0, 1e-3));
  for (const double ratio : r.cone_ratio) {
    EXPECT_LT(ratio, -1.498);
    EXPECT_GT(ratio, -1.667);
  }
}

TEST(MaZhouDeng, drills_faster_under_more_weight) {
  RollerSchedule s = schedule(5.0, 1e-3);
  double before = 0.0;
  for (const double weight : {10e3, 20e3, 40e3}) {
    s.weight = weight;
    const RollerRun r = run(s);
    EXPECT_GT(r.rate, 1.2 * before) << weight;
    before = r.rate;
  }
}

/// A step of 1 ms of friction, taken from the step's beginning, throws a cone of 0.005 kg m2 to and fro.
TEST(MaZhouDeng, needs_the_slip_of_the_steps_end_or_short_steps) {
  const auto spread = [](SlipTime slip, double step) {
    MaZhouDengOptions options;
    options.drilling.sliding.slip = slip;
    const RollerRun r = run(schedule(2.0, step), options);
    double sum = 0.0;
    std::size_t n = 0;
    for (std::size_t i = r.series.cone_speeds.size() / 2; i < r.series.cone_speeds.size(); ++i, ++n)
      sum += std::pow(r.series.cone_speeds[i] + 1.576 * 3.0 * std::numbers::pi, 2);
    return std::sqrt(sum / static_cast<double>(n));
  };
  const double lagged = spread(SlipTime::beginning, 1e-3), at_end = spread(SlipTime::end, 1e-3);
  EXPECT_LT(at_end, 2.0);
  EXPECT_GT(lagged, 5.0 * at_end);
}

/// Teeth that spring back return the work of pressing in: nothing is left to do for the torque but friction.
TEST(MaZhouDeng, drills_with_half_the_torque_when_rock_springs_back) {
  MaZhouDengOptions elastic;
  elastic.drilling.print.release = ToothRelease::elastic;
  const RollerSchedule s = schedule(4.0, 1e-3);
  EXPECT_LT(run(s, elastic).torque, 0.5 * run(s).torque);
}

TEST(MaZhouDeng, is_the_same_run_twice_and_allocates_its_series_at_once) {
  const RollerRun a = run(schedule(1.5, 1e-3)), b = run(schedule(1.5, 1e-3));
  EXPECT_EQ(a.series.depth, b.series.depth);
  EXPECT_EQ(a.bottom.height, b.bottom.height);
  EXPECT_EQ(a.series.depth.size(), a.series.depth.capacity());
  EXPECT_EQ(a.series.cone_speeds.size(), a.series.cone_speeds.capacity());
}

TEST(MaZhouDeng, rejects_what_it_cannot_drill_with) {
  const RollerSchedule good = schedule(2.0, 1e-3);
  const ToothLaw law = example::power_tooth();
  EXPECT_EQ(
      message_of({}, law, good),
      "Ma, Zhou and Deng: found 0 cones with 0 teeth, expected a roller bit: cones with rows of "
      "teeth");
  RollerBit bit = example::roller_bit(0.0);
  bit.cones[1].inertia = 0.0;
  EXPECT_EQ(message_of(bit, law, good),
            "Ma, Zhou and Deng: inertia of cone 2 (kg m2): found 0, expected a positive number");
  bit = example::roller_bit(0.0);
  bit.cones[2].rows[1].tooth_radius = 5e-3;
  EXPECT_EQ(message_of(bit, law, good),
            "Ma, Zhou and Deng: found teeth of 6 and 5 mm radius, expected one kind, that of its "
            "law, or a "
            "sphere radius for all");
  bit = example::roller_bit(0.0);
  RollerSchedule idle = good;
  idle.weight = 0.0;
  EXPECT_NE(message_of(bit, law, idle).find("weight on bit (N): found 0"), std::string::npos);
  ToothTable fragile = example::tooth_table();
  for (double& force : fragile.force) force *= 1e-3;
  EXPECT_NE(message_of(bit, fragile, good).find("Ma, Zhou and Deng: no root for z"),
            std::string::npos);
}

}  // namespace tdbd::reference::ma_zhou_deng_test

namespace tdbd::reference::huang_cawthorne_test {

/// Rounding over 667 steps: rad/s, m.
constexpr double of_speeds = 7e-14, of_depths = 5e-17;

RollerSchedule schedule(double revolutions) {
  return {3.0 * std::numbers::pi, 20e3, 1e-3, revolutions, 0.5 * revolutions};
}

RollerRun run(PatentMethod way, HuangCawthorneOptions options, double revolutions) {
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
  options.prescribed_ratio_revolutions = 0.0;
  options.drilling.print.release = ToothRelease::elastic;
  const RollerRun a = run(PatentMethod::first, options, 1.0),
                  b = run(PatentMethod::second, options, 1.0);
  EXPECT_LT(largest_difference(a.series.cone_speeds, b.series.cone_speeds), of_speeds);
  EXPECT_LT(largest_difference(a.series.depth, b.series.depth), of_depths);
}

TEST(HuangCawthorne, its_ways_part_by_what_is_in_the_torque) {
  HuangCawthorneOptions options;
  const RollerRun averaged = run(PatentMethod::first, options, 4.0),
                  free = run(PatentMethod::second, options, 4.0);
  options.torque_average = 0.0;
  const RollerRun at_once = run(PatentMethod::first, options, 4.0);
  EXPECT_GT(largest_difference(averaged.series.cone_speeds, at_once.series.cone_speeds), 0.1);
  options.bearing = 20.0;
  const RollerRun bearing = run(PatentMethod::second, options, 4.0);
  EXPECT_GT(largest_difference(averaged.series.cone_speeds, free.series.cone_speeds), 0.1);
  EXPECT_GT(largest_difference(bearing.series.cone_speeds, free.series.cone_speeds), 0.1);
  EXPECT_GT(bearing.torque, free.torque);
}

/// On its first turn the first way's cones turn at the ratio that they are given.
TEST(HuangCawthorne, begins_with_a_turn_of_given_ratios) {
  HuangCawthorneOptions options;
  options.first_ratio = 1.4;
  const RollerRun r = run(PatentMethod::first, options, 2.0);
  const double given = -1.4 * 3.0 * std::numbers::pi;
  for (std::size_t i = 0; i < 600; ++i) EXPECT_NEAR(r.series.cone_speeds[3 * i], given, 1e-9);
  EXPECT_GT(std::abs(r.series.cone_speeds.back() - given), 0.1);
}

TEST(HuangCawthorne, rejects_a_table_that_is_not_monotone) {
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

}  // namespace tdbd::reference::huang_cawthorne_test

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "simulation/step/diagnosis.hpp"

namespace tdbd::simulation::steady_state_test {

constexpr double speed = 4.0 * std::numbers::pi;  // rad/s: two revolutions per second

/// So many steps of 1 ms at constant values.
Trace constant_trace(std::size_t steps) {
  Trace t;
  t.dt = 1e-3;
  t.wob.assign(steps, 3e4);
  t.tob.assign(steps, 2e3);
  t.rop.assign(steps, 5e-3);
  t.rotary_speed.assign(steps, speed);
  return t;
}

/// The weight rises by this share over the trace, with noise of this relative deviation.
Trace rising_weight(double share, double noise, std::mt19937_64& random) {
  Trace t = constant_trace(1600);
  for (std::size_t i = 0; i < t.wob.size(); ++i) {
    double normal = -6.0;  // sum of twelve uniform numbers: variance 1
    for (int k = 0; k < 12; ++k) normal += static_cast<double>(random() >> 11) * 0x1p-53;
    t.wob[i] *= 1.0 + share * static_cast<double>(i) / 1600.0 + noise * normal;
  }
  return t;
}

TEST(SteadyState, is_reached_if_no_mean_changes) {
  const SteadyState s = steady_state(constant_trace(1000));
  EXPECT_EQ(s.is_steady, true);
  EXPECT_EQ(s.reason, "");
  EXPECT_NEAR(s.revolutions, 2.0, 1e-9);
  ASSERT_EQ(s.changes.size(), 4U);
  for (const MeanChange& c : s.changes) EXPECT_FALSE(c.is_drifting) << c.name;
  EXPECT_EQ(drifting_means(s), "");
}

TEST(SteadyState, is_not_reached_by_a_mean_that_rises) {
  std::mt19937_64 random(2007);
  const SteadyState s = steady_state(rising_weight(0.1, 0.02, random));
  EXPECT_EQ(s.is_steady, false);
  EXPECT_NEAR(s.changes[0].relative, 0.05 / 1.075, 5e-3) << "half of the rise, over the later mean";
  EXPECT_EQ(drifting_means(s).substr(0, 22), "the weight on bit by +");
  EXPECT_FALSE(s.changes[1].is_drifting);
}

/// A change of less than one per cent is accepted however certain it is.
TEST(SteadyState, ignores_changes_that_do_not_matter) {
  std::mt19937_64 random(2007);
  const SteadyState s = steady_state(rising_weight(0.015, 0.0, random));
  EXPECT_EQ(s.is_steady, true);
  EXPECT_GT(s.changes[0].t, drift_t);
}

/// Noise of ten times the mean makes changes of the mean large, and chance explains them.
TEST(SteadyState, is_rarely_denied_to_noise) {
  constexpr int runs = 2000;
  std::mt19937_64 random(2007);
  int denied = 0;
  for (int run = 0; run < runs; ++run)
    if (steady_state(rising_weight(0.0, 10.0, random)).changes[0].is_drifting) ++denied;
  // One of four means: a quarter of 5 %. Three standard deviations of the count are 0.0075.
  EXPECT_NEAR(denied / double{runs}, 0.0125, 0.0075);
}

TEST(SteadyState, accepts_a_vibration_of_many_cycles) {
  Trace t = constant_trace(1600);
  for (std::size_t i = 0; i < t.wob.size(); ++i)
    t.rotary_speed[i] *= 1.0 + std::sin(0.1 * static_cast<double>(i));
  EXPECT_EQ(steady_state(t).is_steady, true);
}

TEST(SteadyState, is_not_decided_by_less_than_a_revolution_or_few_steps) {
  const SteadyState part = steady_state(constant_trace(490));
  EXPECT_EQ(part.is_steady, std::nullopt);
  EXPECT_EQ(part.reason, "the means cover 0.98 revolutions, less than one");
  Trace coarse = constant_trace(15);
  coarse.dt = 1.0;
  EXPECT_EQ(steady_state(coarse).reason, "15 steps in the means, fewer than 16");
  EXPECT_EQ(steady_state({}).is_steady, std::nullopt);
}

/// The same from a formula without batches' means of means: 32 steps, two per batch.
TEST(SteadyState, t_is_the_change_over_its_standard_error) {
  Trace t = constant_trace(33);
  t.dt = 0.1;
  t.tob[0] = 1e9;  // left out
  double sums[2] = {}, squares[2] = {};
  for (int half = 0; half < 2; ++half)
    for (int batch = 0; batch < 8; ++batch) {
      const double value = 100.0 + 40.0 * half + 3.0 * (batch * batch % 5);
      const std::size_t at = 1 + static_cast<std::size_t>(16 * half + 2 * batch);
      t.tob[at] = value - 7.0;
      t.tob[at + 1] = value + 7.0;
      sums[half] += value;
      squares[half] += value * value;
    }
  double variance = 0.0;
  for (int half = 0; half < 2; ++half)
    variance += (squares[half] - sums[half] * sums[half] / 8.0) / 7.0 / 8.0;
  const SteadyState s = steady_state(t);
  EXPECT_NEAR(s.changes[1].t, (sums[1] - sums[0]) / 8.0 / std::sqrt(variance), 1e-9);
  const auto json = to_json(s);
  EXPECT_EQ(json.at("means").at("tob_mean_n_m").at("drifts"), true);
  EXPECT_EQ(json.at("t_limit"), drift_t);
}

}  // namespace tdbd::simulation::steady_state_test

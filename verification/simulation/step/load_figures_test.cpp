#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "simulation/step/loads.hpp"

namespace tdbd::simulation::load_figures_test {

constexpr double pi = std::numbers::pi, rounding = 1e-12;

/// Two parts of one cutter, and a pad.
bit::Bit small_bit() {
  bit::Bit bit;
  bit.gage_radius = 0.1;
  bit.parts.resize(3);
  const char* names[] = {"cutter-1/face", "cutter-1/chamfer", "gage-pad-1"};
  for (std::size_t i = 0; i < 3; ++i) bit.parts[i].name = names[i];
  bit.parts[0].cutter = bit.parts[1].cutter = 0;
  bit.parts[2].cutter = -1;
  return bit;
}

/// A step of 10 ms: a bit on its axis, quarter turned, under the weight `w` (N).
void add_step(double w, LoadStatistics& s, Trace& t) {
  BitLoads loads;
  loads.force_W = Vec3(0.0, 300.0, -w);
  loads.torque_W = Vec3(1.0, 2.0, -0.02 * w);
  loads.power = 50.0;
  loads.parts.resize(3);
  loads.parts[0] = {Vec3::Zero(), Vec3::Zero(), w, 0.5 * w, 30.0};
  loads.parts[1] = {Vec3::Zero(), Vec3::Zero(), 7.0, 3.0, 20.0};
  BitVelocity v;
  v.v_W = Vec3(0.0, 0.0, 0.004);
  v.w_W = Vec3(0.0, 0.0, 12.0);
  const Pose X_WB{Eigen::AngleAxisd(0.5 * pi, Vec3::UnitZ()).toRotationMatrix(),
                  Vec3(1e-3, 2e-3, 0.0)};
  const std::vector<double> removed{4e-9, 1e-9, 0.0};
  const LoadedStep step{loads, v, X_WB, removed, 0.01, rates_of(v, X_WB)};
  add(step, s);
  add(step, t);
}

struct Sums {
  LoadStatistics s;
  Trace t;
};

const Sums& two_steps() {
  static const Sums sums = [] {
    Sums made;
    for (const double w : {900.0, 1100.0}) add_step(w, made.s, made.t);
    return made;
  }();
  return sums;
}

/// Of a move: its way along z and its turn, over the time. Of a velocity: along z, and about the bit's
/// axis, which here points along -y.
TEST(LoadStatisticsSummary, rates_are_displacements_over_time) {
  const Mat3 R = Eigen::AngleAxisd(0.5 * pi, Vec3::UnitX()).toRotationMatrix();
  const Move move{{R, Vec3(1.0, 2.0, 0.25)}, {R, Vec3(4.0, 5.0, 0.75)}, 0.125, 3.0, 0};
  EXPECT_EQ(rates_of(move).penetration, 4.0);
  EXPECT_EQ(rates_of(move).rotary, 24.0);
  BitVelocity v;
  v.v_W = Vec3(1.0, 2.0, 3.0);
  v.w_W = Vec3(4.0, 5.0, 6.0);
  EXPECT_EQ(rates_of(v, move.X_WB1).penetration, 3.0);
  EXPECT_NEAR(rates_of(v, move.X_WB1).rotary, -5.0, rounding);
}

TEST(LoadStatisticsSummary, are_means_and_deviations_of_steps) {
  const LoadStatisticsSummary f = summarize(small_bit(), two_steps().s, 5.0);
  EXPECT_EQ(f.steps, 2);
  EXPECT_NEAR(f.from, 4.98, rounding);
  EXPECT_EQ(f.to, 5.0);
  EXPECT_NEAR(f.wob.mean, 1000.0, rounding * 1000.0);
  EXPECT_NEAR(f.wob.deviation, 100.0, rounding * 1000.0);
  EXPECT_NEAR(f.tob.mean, 20.0, rounding * 20.0);
  EXPECT_NEAR(f.tob.deviation, 2.0, rounding * 20.0);
  EXPECT_EQ(f.rop.mean, 0.004);
  EXPECT_NEAR(f.rotary_speed.mean, 12.0, rounding * 12.0);
  EXPECT_NEAR(f.power, 50.0, rounding * 50.0);
}

/// 3 T/(D W); W/A + w T/(A v); the side force over the weight, in the bit's frame a quarter back.
TEST(LoadStatisticsSummary, have_the_ratios_of_drilling) {
  const LoadStatisticsSummary f = summarize(small_bit(), two_steps().s, 5.0);
  const double area = pi * 0.01;
  EXPECT_NEAR(f.aggressiveness, 3.0 * 20.0 / (0.2 * 1000.0), rounding);
  EXPECT_DOUBLE_EQ(f.specific_energy, 1000.0 / area + 12.0 * 20.0 / (area * 0.004));
  EXPECT_NEAR(f.imbalance, 0.3, rounding);
  EXPECT_NEAR(f.imbalance_azimuth, 0.0, rounding);
}

/// What a part removed is what its whole cutter did; parts without a force are left out.
TEST(LoadStatisticsSummary, have_every_part_with_a_force) {
  const LoadStatisticsSummary f = summarize(small_bit(), two_steps().s, 5.0);
  ASSERT_EQ(f.parts.size(), 2U);
  EXPECT_EQ(f.parts[0].name, "cutter-1/face");
  EXPECT_DOUBLE_EQ(f.parts[0].normal.mean, 1000.0);
  EXPECT_DOUBLE_EQ(f.parts[0].tangential.mean, 500.0);
  EXPECT_DOUBLE_EQ(f.parts[0].power, 30.0);
  EXPECT_NEAR(f.parts[0].removed, 1e-8, 1e-20);
  EXPECT_DOUBLE_EQ(f.parts[0].specific_energy, 0.6 / 1e-8);
  EXPECT_EQ(f.parts[1].name, "cutter-1/chamfer");
  EXPECT_NEAR(f.parts[1].removed, 1e-8, 1e-20);
}

TEST(LoadStatisticsSummary, of_no_step_are_nothing) {
  const LoadStatisticsSummary f = summarize(small_bit(), {}, 5.0);
  EXPECT_EQ(f.steps, 0);
  EXPECT_EQ(f.aggressiveness, 0.0);
  EXPECT_EQ(f.specific_energy, 0.0);
  EXPECT_EQ(f.power, 0.0);
  EXPECT_TRUE(f.parts.empty());
}

TEST(LoadStatisticsSummary, leave_a_trace) {
  const Trace& t = two_steps().t;
  EXPECT_EQ(t.dt, 0.01);
  EXPECT_EQ(t.wob, (std::vector{900.0, 1100.0}));
  EXPECT_EQ(t.tob.size(), 2U);
  EXPECT_EQ(t.rop.size(), 2U);
  ASSERT_EQ(t.rotary_speed.size(), 2U);
  EXPECT_NEAR(t.rotary_speed[1], 12.0, rounding * 12.0);
  ASSERT_EQ(t.centre_W.size(), 2U);
  EXPECT_EQ(t.centre_W[0], Eigen::Vector2d(1e-3, 2e-3));
}

TEST(BatchUncertainty, is_that_of_eight_batches) {
  EXPECT_EQ(batch_uncertainty(std::vector<double>(7, 3.0)), std::nullopt);
  EXPECT_EQ(batch_uncertainty(std::vector<double>(800, 3.0)), 0.0);
  std::vector<double> steps(1, 1e6);  // left out: 16 samples make eight batches
  for (int i = 0; i < 8; ++i) steps.insert(steps.end(), 2, i % 2 == 0 ? 1.0 : -1.0);
  EXPECT_NEAR(*batch_uncertainty(steps), 2.364624 / std::sqrt(7.0), rounding);
}

/// Noise that remembers a tenth of a batch (an autoregressive process): the interval has the true
/// mean, 0, in 95 of 100 runs. The standard error of independent samples would have it in 30.
TEST(BatchUncertainty, covers_the_mean_of_correlated_noise) {
  constexpr double memory = 0.95;
  constexpr int runs = 2000, length = 1600;
  std::mt19937_64 random(2007);
  int covered = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> x(length);
    double last = 0.0, mean = 0.0;
    for (double& v : x) {
      double normal = -6.0;  // sum of twelve uniform numbers: variance 1
      for (int k = 0; k < 12; ++k) normal += static_cast<double>(random() >> 11) * 0x1p-53;
      v = last = memory * last + normal;
      mean += v / length;
    }
    if (std::abs(mean) <= *batch_uncertainty(x)) ++covered;
  }
  EXPECT_NEAR(covered / double{runs}, sampling_coverage, 0.02);
}

}  // namespace tdbd::simulation::load_figures_test

#include "verification/battery/golden.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace tdbd::battery::golden_test {

/// The files have 17 digits and momenta of at most 60 N m s, energies of at most 1300 J.
constexpr double rounding = 1e-13;  // of the largest term

double scale(const GoldenState& s) { return 1.0 + s.body_momentum_B.norm() + std::abs(s.energy); }

TEST(Golden, states_satisfy_the_inertia_relations) {
  for (const std::string& name : golden_names()) {
    const GoldenCase c = read_golden_case(name);
    ASSERT_EQ(c.states.size(), 5u) << name;
    for (const GoldenState& s : c.states) {
      Vec3 momentum_B = c.gyrostat.inertia_B * s.w_B;
      for (std::size_t k = 0; k < c.gyrostat.cones.size(); ++k) {
        const dynamics::Cone& cone = c.gyrostat.cones[k];
        const double spin = s.cone_momenta[k] / cone.axial_inertia - cone.axis_B.dot(s.w_B);
        momentum_B += cone.axial_inertia * spin * cone.axis_B;
      }
      EXPECT_LE((momentum_B - s.body_momentum_B).norm(), rounding * scale(s)) << name;
      EXPECT_LE((s.R_WB * momentum_B - s.momentum_W).norm(), rounding * scale(s)) << name;
    }
  }
}

TEST(Golden, free_and_heavy_cases_keep_what_they_must) {
  for (const std::string& name : golden_names()) {
    const GoldenCase c = read_golden_case(name);
    if (!c.loads.body_torque_B.isZero()) continue;
    for (const GoldenState& s : c.states) {
      EXPECT_NEAR(s.energy, c.states[0].energy, rounding * scale(s)) << name;
      EXPECT_NEAR(s.momentum_W.z(), c.states[0].momentum_W.z(), rounding * scale(s)) << name;
    }
  }
}

TEST(Golden, initial_state_is_the_first_state) {
  const GoldenCase c = read_golden_case("heavy_gyro_phys");
  EXPECT_LE((c.initial.q_WB.toRotationMatrix() - c.states[0].R_WB).norm(), 1e-15);
  EXPECT_EQ(c.initial.momentum_W, c.states[0].momentum_W);
  EXPECT_EQ(c.initial.cone_momenta, c.states[0].cone_momenta);
  EXPECT_EQ(c.initial.cone_angles, std::vector<double>(3, 0.0));
  EXPECT_EQ(c.loads.cones.size(), 3u);
}

TEST(Golden, steps_name_every_drift_and_how_many) {
  for (const std::string& name : golden_names()) {
    const std::vector<GoldenStep> steps = read_golden_steps(name);
    ASSERT_EQ(steps.size(), 6u) << name;
    EXPECT_EQ(steps[0].drift, "LieMid");
    EXPECT_EQ(steps[0].drifts_per_step, 2);
    EXPECT_EQ(steps[5].drift, "SplitSph");
    EXPECT_EQ(steps[5].drifts_per_step, 1);
    EXPECT_EQ(steps[5].h, name == "fast_top" ? 0.005 : 0.02);
    EXPECT_DOUBLE_EQ(steps[5].after_100.time, 100.0 * steps[5].h);
    const Mat3& R_WB = steps[5].after_100.R_WB;
    EXPECT_LE((R_WB * R_WB.transpose() - Mat3::Identity()).norm(), rounding) << name;
  }
}

TEST(Golden, a_missing_file_is_named) { EXPECT_THROW(read_golden_case("no_such_top"), InputError); }

}  // namespace tdbd::battery::golden_test

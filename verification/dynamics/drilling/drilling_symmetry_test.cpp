#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "dynamics/drilling/divergence.hpp"
#include "dynamics/rotation/step.hpp"
#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_symmetry_test {

/// Largest difference of two states, each quantity by its size in these problems.
double difference(const DrillingState& a, const DrillingState& b) {
  double worst = (a.c_W - b.c_W).norm() / 0.1;
  const auto take = [&](double x) { worst = std::max(worst, std::abs(x)); };
  take((a.momentum_W - b.momentum_W).norm() / 30.0);
  take((a.rotation.q_WB.toRotationMatrix() - b.rotation.q_WB.toRotationMatrix()).norm());
  take((a.rotation.momentum_W - b.rotation.momentum_W).norm() / 20.0);
  for (std::size_t k = 0; k < a.rotation.cone_momenta.size(); ++k) {
    take(a.rotation.cone_angles[k] - b.rotation.cone_angles[k]);
    take(a.rotation.cone_momenta[k] - b.rotation.cone_momenta[k]);
  }
  take((a.rock_z - b.rock_z) / 1e-3);
  take((a.rock_momentum - b.rock_momentum) / 0.2);
  return worst;
}

/// The same problem turned about space z. The bit's own frame turns along: its attitude is R times
/// what it was.
Mat3 turned(const Mat3& A, const Mat3& R) { return R * A * R.transpose(); }

DrillingSystem turned(DrillingSystem s, const Mat3& R) {
  s.string.rest_W = R * s.string.rest_W;
  s.string.stiffness = turned(s.string.stiffness, R);
  s.string.damping = turned(s.string.damping, R);
  s.string.turn_damping = turned(s.string.turn_damping, R);
  return make_drilling_system(s);
}

DrillingState turned(DrillingState x, const Mat3& R, double angle) {
  x.c_W = R * x.c_W;
  x.momentum_W = R * x.momentum_W;
  x.rotation.q_WB = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * x.rotation.q_WB;
  x.rotation.momentum_W = R * x.rotation.momentum_W;
  return x;
}

/// Resists alike in every direction across.
void round_law(const DrillingSystem&, const DrillingState& x, const DrillingVelocity& v,
               Wrench& w) {
  w.force_W = -80.0 * v.v_W.norm() * v.v_W - 4e3 * (x.c_W.z() + 0.2 - x.rock_z) * Vec3::UnitZ();
  w.torque_W = -3.0 * v.w_W;
  w.rock_force = -w.force_W.z();
}

/// To rounding. Dampers act one principal direction after another, so that a bit which couples
/// them knows the directions' order, by an error of the step's size; here nothing couples them.
RC_GTEST_PROP(DrillingSymmetry, nothing_changes_when_everything_turns_about_z, ()) {
  const double angle = *battery::number(-1.0, 1.0);
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string.attachment_B = s.centre_B;  // across, the string's damper is one number then
  s.string.damping = Vec3(200.0, 200.0, 900.0).asDiagonal();
  s.string.turn_damping = Vec3(0.0, 0.0, 9.0).asDiagonal();
  s.string.turn_stiffness = Vec3(2e3, 2e3, 0.0).asDiagonal();
  s = make_drilling_system(s);
  const DrillingSystem there = turned(s, R);
  DrillingRun a = start(s, round_law, coupled_start(s));
  DrillingRun b = start(there, round_law, turned(coupled_start(s), R, angle));
  for (int i = 0; i < 200; ++i) {
    step(s, round_law, 1e-3, a);
    step(there, round_law, 1e-3, b);
  }
  RC_ASSERT(difference(turned(a.state, R, angle), b.state) < 1.7e-12);
}

/// The step by -h undoes the step, dampers included: their flows are exact. A law of place alone;
/// friction, which forgets, and wall that loses are off.
TEST(DrillingSymmetry, step_back_undoes_the_step) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  s.wall.friction = 0.0;
  s = make_drilling_system(s);
  const LumpedLaw of_place = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    w.force_W.z() = -4e3 * std::pow(x.c_W.z() - x.rock_z + 0.2, 2);
    w.rock_force = -w.force_W.z();
  };
  const DrillingState from = coupled_start(s);
  DrillingRun d = start(s, of_place, from);
  for (int i = 0; i < 100; ++i) step(s, of_place, 1e-3, d);
  EXPECT_GT(difference(d.state, from), 0.1);
  for (int i = 0; i < 100; ++i) step(s, of_place, -1e-3, d);
  EXPECT_LT(difference(d.state, from), 1e-13);
}

TEST(DrillingSymmetry, a_resumed_run_is_the_same_to_the_bit) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  DrillingRun through = start(s, smooth_law, coupled_start(s));
  for (int i = 0; i < 50; ++i) step(s, smooth_law, 1e-3, through);
  DrillingRun resumed = go_on(s, {through.state, through.wrench, through.ledger, {}});
  for (int i = 0; i < 50; ++i) {
    step(s, smooth_law, 1e-3, through);
    step(s, smooth_law, 1e-3, resumed);
  }
  EXPECT_EQ(difference(through.state, resumed.state), 0.0);
  EXPECT_EQ(residual(s, through), residual(s, resumed));
}

/// A drift that solves may be too long: the run stops with the state before the step.
TEST(DrillingSymmetry, a_drift_that_is_too_long_leaves_everything_as_it_was) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.integrator.drift = Drift::lie_midpoint;
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  step(s, smooth_law, 1e-3, d);
  const DrillingRun before = d;
  EXPECT_THROW(open_step(s, 5.0, d, d.work), RunError);
  EXPECT_EQ(difference(d.state, before.state), 0.0);
  EXPECT_EQ(d.state.rotation.time, before.state.rotation.time);
  EXPECT_EQ(residual(s, d), residual(s, before));
  step(s, smooth_law, 1e-3, d);  // a shorter one goes on
  EXPECT_EQ(divergence(s, d, d.work), "");
}

/// Without string and rock the rotation is that of `tdbd rotate`, bit for bit, and the centre goes
/// straight on.
TEST(DrillingSymmetry, a_free_bit_turns_as_the_gyrostat_alone) {
  DrillingSystem s;
  s.mass = 100.0;
  s.gyrostat = coupled_bit(AxialMode::rate, DamperEnd::space).gyrostat;
  s = make_drilling_system(s);
  const DrillingState from = coupled_start(s);
  DrillingRun d = start(s, nullptr, from);
  Rotating alone = dynamics::start(s.gyrostat, Loads{}, from.rotation);
  for (int i = 0; i < 1000; ++i) {
    step(s, nullptr, 1e-3, d);
    dynamics::step(s.gyrostat, Loads{}, Integrator{}, 1e-3, alone);
  }
  EXPECT_EQ(d.state.rotation.q_WB.coeffs(), alone.state.q_WB.coeffs());
  EXPECT_EQ(d.state.rotation.cone_angles, alone.state.cone_angles);
  EXPECT_EQ(d.state.momentum_W, from.momentum_W);
  EXPECT_LT((d.state.c_W - from.c_W - from.momentum_W / s.mass).norm(), 1e-14);
}

/// A bit in a hole that it does not touch, on a slack string, feels nothing.
TEST(DrillingSymmetry, a_bit_that_touches_nothing_feels_nothing) {
  DrillingSystem s = plain_bit();
  s.wall = {1e9, 0.01, 0.1, 0.0, 0.5, 0.3, 1e-3};
  s.string.stiffness = (7e5 * Mat3::Identity()).eval();
  s.string.turn_stiffness = (900.0 * Mat3::Identity()).eval();
  s.string.damping = (1e4 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, nullptr, 1e-3, d);
  EXPECT_EQ(d.state.c_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(d.state.momentum_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(d.state.rotation.momentum_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(residual(s, d), 0.0);
}

}  // namespace tdbd::dynamics::drilling_symmetry_test

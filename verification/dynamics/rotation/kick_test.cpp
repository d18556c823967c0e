#include "dynamics/rotation/kick.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace tdbd::dynamics::kick_test {

constexpr double rounding = 1e-14;

/// A body with one cone, damped about every axis and in the bearing.
struct Damped {
  Gyrostat g = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {{Vec3(0.6, 0.0, 0.8), 0.1}});
  Loads loads;
  Rotating r;

  explicit Damped(double damping) {
    loads.damping_W = damping * Vec3::Ones();
    loads.cones.push_back({.internal = 0.0, .external = 0.0, .damping = 0.01 * damping});
    const double spin[] = {-6.0}, angle[] = {0.0};
    r.state = make_state(g, Mat3::Identity(), Vec3(1.0, -2.0, 3.0), spin, angle);
    evaluate(g, loads, r.state, r.torque);
  }
};

TEST(SymmetricKick, is_undone_by_the_opening_kick_of_the_step_back) {
  Damped d(0.5);
  const RotationState before = d.r.state;
  implicit_kick(d.g, d.loads, 0.05, d.r);
  EXPECT_GT((d.r.state.momentum_W - before.momentum_W).norm(), 0.01);
  kick(-0.05, d.r.torque, d.r.state);
  EXPECT_LE((d.r.state.momentum_W - before.momentum_W).norm(), rounding);
  EXPECT_NEAR(d.r.state.cone_momenta[0], before.cone_momenta[0], rounding);
}

TEST(SymmetricKick, counts_its_evaluations) {
  Damped d(0.5);
  d.r.evaluations = 1;
  implicit_kick(d.g, d.loads, 0.05, d.r);
  EXPECT_GE(d.r.evaluations, 3);
  EXPECT_LE(d.r.evaluations, 25);
}

TEST(SymmetricKick, says_when_the_damping_is_too_strong_for_the_step) {
  Damped d(500.0);
  EXPECT_THROW(implicit_kick(d.g, d.loads, 0.05, d.r), RunError);
}

TEST(MomentumDifference, watches_the_cones_too) {
  const Damped d(0.5);
  RotationState other = d.r.state;
  other.cone_momenta[0] += 1e-3;
  EXPECT_GT(momentum_difference(d.r.state, other), 1e-9);
}

}  // namespace tdbd::dynamics::kick_test

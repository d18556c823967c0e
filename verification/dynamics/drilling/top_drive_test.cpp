#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/observed_order.hpp"
#include "rotation/swing_twist.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

namespace tdbd::dynamics::top_drive_test {

constexpr double h = 1e-3;  ///< s

/// Rock that resists with 8.6e6 N a metre of depth, and a torque in proportion.
void springy_rock(const DrillingSystem&, const DrillingState& x, const DrillingVelocity&,
                  Wrench& w) {
  w.force_W.z() = -8.6e6 * std::max(x.c_W.z(), 0.0);
  w.torque_W.z() = 0.1 * w.force_W.z();
}

DrillingSystem damped_bit() {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness.diagonal() = Vec3(7e5, 7e5, 7e5);
  s.string.damping.diagonal() = Vec3(3e4, 3e4, 1e5);
  s.string.turn_stiffness.diagonal() = Vec3(1e5, 1e5, 938.0);
  s.string.turn_damping.diagonal() = Vec3(1e3, 1e3, 300.0);
  return s;
}

/// Weight on bit: a staircase of loads is what the rock carries, whatever the bit weighs.
TEST(TopDrive, staircase_of_loads_is_the_weight_on_bit) {
  DrillingSystem s = damped_bit();
  s.top.axial = AxialMode::load;
  s.top.load = make_schedule(Interpolation::stepwise, {0.0, 1.0, 2.0}, {5e3, 2e4, 1e4});
  s = make_drilling_system(s);
  DrillingRun d = start(s, springy_rock, at_rest(s));
  for (const double load : {5e3, 2e4, 1e4}) {
    for (int i = 0; i < 999; ++i) step(s, springy_rock, h, d);
    EXPECT_NEAR(-d.wrench.force_W.z(), load, 1e-12 * load);
    step(s, springy_rock, h, d);
  }
}

/// An axial damper to space takes its part of the load while the bit drills on; one to the top
/// takes none when the top knows the rate.
TEST(TopDrive, damper_to_the_top_leaves_the_load_on_the_bit) {
  constexpr double load = 2e4, rate = 15.0 / 3600.0;
  const LumpedLaw viscous = [](const auto&, const auto&, const DrillingVelocity& v, Wrench& w) {
    w.force_W.z() = -load / rate * v.v_W.z();  // drills at `rate` under `load`
  };
  for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
    DrillingSystem s = damped_bit();
    s.mass = 1e4;
    s.string.damping(2, 2) = 1.4e5;
    s.string.damper_end = end;
    s.top = {{}, AxialMode::load, constant(rate), constant(load)};
    s = make_drilling_system(s);
    DrillingRun d = start(s, viscous, at_rest(s));
    for (int i = 0; i < 1000; ++i) step(s, viscous, 1e-4, d);
    const double taken = end == DamperEnd::space ? load * 1.4e5 / (1.4e5 + load / rate) : 0.0;
    EXPECT_NEAR(-d.wrench.force_W.z(), load - taken, 6.5e-9 * load);
  }
}

/// A bit that follows `load` through rock of viscosity c, its damper to a top that follows it.
struct FollowedBit {
  double mass = 1e4, damping = 1.4e5, rock = 5e5, load = 2e4, following_time = 0.05;

  DrillingSystem system() const {
    DrillingSystem s = plain_bit();
    s.gravity = 9.81;
    s.mass = mass;
    s.string.damping(2, 2) = damping;
    s.string.damper_end = DamperEnd::top;
    s.top.axial = AxialMode::load;
    s.top.load = constant(load);
    s.top.following_time = following_time;
    return make_drilling_system(s);
  }
  /// The same beside a wall that the bit does not touch: forces and dampers act in one flow.
  DrillingSystem system_with_wall() const {
    DrillingSystem s = system();
    s.wall.stiffness = 1e6;
    s.wall.clearance = 1.0;
    return s;
  }
  LumpedLaw law() const {
    return [c = rock](const auto&, const auto&, const DrillingVelocity& v, Wrench& w) {
      w.force_W.z() = -c * v.v_W.z();
    };
  }
  DrillingRun started(double speed, double top_rate) const {
    const DrillingSystem s = system();
    DrillingState from = at_rest(s);
    from.momentum_W.z() = mass * speed;
    from.top_rate = top_rate;
    return start(s, law(), from);
  }
  /// The velocities of bit and top after a time: M v' = W - c v - D (v - r), r' = (v - r) / tau.
  Eigen::Vector2d exact(double speed, double top_rate, double time) const {
    Eigen::Matrix2d A;
    A << -(rock + damping) / mass, damping / mass, 1.0 / following_time, -1.0 / following_time;
    const Eigen::Vector2d steady = Eigen::Vector2d::Constant(load / rock);
    const Eigen::EigenSolver<Eigen::Matrix2d> modes(A);
    const Eigen::Vector2cd of = modes.eigenvectors().colPivHouseholderQr().solve(
        (Eigen::Vector2d(speed, top_rate) - steady).cast<std::complex<double>>());
    const Eigen::Vector2cd grown = (time * modes.eigenvalues().array()).exp() * of.array();
    return steady + (modes.eigenvectors() * grown).real();
  }
};

/// A top that follows the bit: whatever rate was expected, the rock carries the load.
TEST(TopDrive, that_follows_the_bit_leaves_the_load_on_it) {
  const FollowedBit bit;
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    for (const double expected : {0.0, 0.04, 1.0}) {
      DrillingRun d = bit.started(expected, expected);
      for (int i = 0; i < 3000; ++i) step(s, bit.law(), h, d);
      EXPECT_NEAR(-d.wrench.force_W.z(), bit.load, 1e-12 * bit.load) << expected;
      EXPECT_NEAR(d.state.top_rate, bit.load / bit.rock, 1e-13) << expected;
    }
}

TEST(TopDrive, that_follows_the_bit_moves_as_its_equations_do) {
  const FollowedBit bit;
  constexpr double time = 0.08, speed = 0.3, top_rate = -0.1;
  const Eigen::Vector2d exact = bit.exact(speed, top_rate, time);
  const auto error = [&](const DrillingSystem& s, int count) {
    DrillingRun d = bit.started(speed, top_rate);
    for (int i = 0; i < count; ++i) step(s, bit.law(), time / count, d);
    return Eigen::Array2d(velocity(s, d.state).v_W.z() - exact[0], d.state.top_rate - exact[1]);
  };
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    for (const int count : {80, 160}) {
      const Eigen::Array2d order =
          (error(s, count) / error(s, 2 * count)).abs().log() / std::log(2.0);
      EXPECT_NEAR(order[0], 2.0, 0.1) << "bit";
      EXPECT_NEAR(order[1], 2.0, 0.1) << "top";
    }
}

/// The dampers' loss and the top's work are in the ledger: what is left is of second order.
TEST(TopDrive, that_follows_the_bit_has_a_ledger_of_second_order) {
  const FollowedBit bit;
  const auto left = [&](const DrillingSystem& s, int count) {
    DrillingRun d = bit.started(0.3, -0.1);
    double lost = 0.0;
    for (int i = 0; i < count; ++i) {
      step(s, bit.law(), 0.5 / count, d);
      EXPECT_GE(d.ledger.damped_string, lost);
      lost = d.ledger.damped_string;
    }
    EXPECT_GT(lost, 0.1 * d.ledger.start);
    return residual(s, d);
  };
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    EXPECT_NEAR(std::log2(left(s, 500) / left(s, 1000)), 2.0, 0.05);
}

/// Lowered at a rate: the string's spring is stretched by what the rock carries, less the weight.
TEST(TopDrive, lowering_presses_through_the_axial_spring) {
  DrillingSystem s = damped_bit();
  s.top.rate = make_schedule(Interpolation::stepwise, {0.0, 0.5}, {0.04, 0.0});  // 20 mm in all
  s = make_drilling_system(s);
  DrillingRun d = start(s, springy_rock, at_rest(s));
  for (int i = 0; i < 3000; ++i) step(s, springy_rock, h, d);
  const double depth = (7e5 * 0.02 + 500.0 * 9.81) / (7e5 + 8.6e6);
  EXPECT_NEAR(d.state.c_W.z(), depth, 1e-12 * depth);
}

/// A top that turns ten times winds up a held bit by as much, and the twist is torque over Kr.
TEST(TopDrive, windings_count) {
  DrillingSystem s = damped_bit();
  s.gravity = 0.0;
  s.top.speed = make_schedule(Interpolation::stepwise, {0.0, 10.0}, {2.0 * std::numbers::pi, 0.0});
  s = make_drilling_system(s);
  const LumpedLaw holds = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    w.torque_W.z() = -1e5 * rotation::twist_angle(x.rotation.q_WB, x.rotation.turns);
  };
  DrillingRun d = start(s, holds, at_rest(s));
  for (int i = 0; i < 15'000; ++i) step(s, holds, h, d);
  const double held = 938.0 * 20.0 * std::numbers::pi * 1e5 / (1e5 + 938.0);
  EXPECT_NEAR(d.wrench.torque_W.z(), -held, 1e-12 * held);
  EXPECT_NEAR(d.ledger.top, 0.5 * 938.0 * std::pow(20.0 * std::numbers::pi, 2), 2e4);
}

/// A ramp of speeds is followed with the lag of its acceleration, Kr lag = I acceleration, but for
/// an error of second order.
TEST(TopDrive, ramp_of_speeds_is_followed) {
  DrillingSystem s = damped_bit();
  s.gravity = 0.0;
  s.string.damper_end = DamperEnd::top;
  s.top.speed = make_schedule(Interpolation::linear, {0.0, 20.0}, {0.0, 20.0});
  s = make_drilling_system(s);
  constexpr double exact = 2.0 / 938.0, slow = 2e-5;
  std::vector<double> steps, errors;
  for (int n = 2500; n <= 40'000; n *= 2) {
    DrillingRun d = start(s, nullptr, at_rest(s));
    for (int i = 0; i < n; ++i) step(s, nullptr, 10.0 / n, d);
    const double lag = top_position(s, d.state).angle -
                       rotation::twist_angle(d.state.rotation.q_WB, d.state.rotation.turns);
    if (n == 10'000) {
      EXPECT_NEAR(velocity(s, d.state).w_W.z(), 10.0, slow);
    }
    steps.push_back(10.0 / n);
    errors.push_back(std::abs(lag - exact) / exact);
  }
  EXPECT_NEAR(least_squares_order(steps, errors), 2.0, 0.01);
  EXPECT_LT(errors.back(), 2e-4);
}

}  // namespace tdbd::dynamics::top_drive_test

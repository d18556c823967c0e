#include <gtest/gtest.h>

#include <numbers>

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

/// A ramp of speeds is followed with the lag of its acceleration: Kr lag = I acceleration.
TEST(TopDrive, ramp_of_speeds_is_followed) {
  DrillingSystem s = damped_bit();
  s.gravity = 0.0;
  s.string.damper_end = DamperEnd::top;
  s.top.speed = make_schedule(Interpolation::linear, {0.0, 20.0}, {0.0, 20.0});
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 10'000; ++i) step(s, nullptr, h, d);
  const double lag = top_position(s, d.state.rotation.time).angle -
                     rotation::twist_angle(d.state.rotation.q_WB, d.state.rotation.turns);
  EXPECT_NEAR(velocity(s, d.state).w_W.z(), 10.0, 1.5e-11);
  EXPECT_NEAR(lag, 2.0 / 938.0, 5e-12);
}

}  // namespace tdbd::dynamics::top_drive_test

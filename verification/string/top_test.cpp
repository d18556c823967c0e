#include "string/top.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/types.hpp"
#include "string/chain.hpp"
#include "string/node_flow.hpp"
#include "string/statics.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::top_test {

using std::numbers::pi;

constexpr double frequencies[] = {0.12, 0.16, 0.20, 0.25, 0.40, 1.0};
constexpr double reflected[] = {0.98856, 0.94041, 0.0, 0.94041, 0.99417, 0.99943};

Top soft_top() {
  Top top;
  top.torsion = Top::Torsion::pi;
  top.inertia = 2900.0;
  tune_soft_torque(top, torsional_impedance(drill_pipe(1.0)), 1.0, 0.2);
  return top;
}

TEST(Top, reflection_of_a_soft_torque_is_that_of_the_closed_form) {
  const double impedance = torsional_impedance(drill_pipe(1.0));
  EXPECT_NEAR(impedance, 296.5, 0.05);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(reflection(soft_top(), impedance, frequencies[k]), reflected[k], 5e-6);
}

/// A hump of speed runs up a pipe so long that nothing comes back from its lower end. Below the top
/// its two waves are separated by speed and torque, and compared by frequency.
TEST(Top, a_chain_below_a_soft_torque_reflects_as_the_closed_form) {
  const int n = 4800, probe = 2;
  const Section pipe = drill_pipe(40.0 * n);
  Chain c = make_chain({pipe}, vertical(), 0.0, n);
  c.directions = Directions::torsion;
  c.top = soft_top();
  const double z = torsional_impedance(pipe), h = 40.0 / torsional_wave_speed(pipe);
  const SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  Running r = at_rest(c);
  const auto angle = [](double i) {
    const double x = std::clamp((i - 10.0) / 20.0, 0.0, 1.0);
    return x - std::sin(2.0 * pi * x) / (2.0 * pi);
  };
  for (int i = 0; i < n; ++i) {  // moving up: the speed is the wave's times the slope
    r.state.chain.angle[at(i)] = angle(i);
    r.state.chain.rotary_speed[at(i)] = 0.5 / h * (angle(i + 1.0) - angle(i - 1.0));
  }
  r.state.bit.angle = 1.0;
  r.work = chain_work(c, r.state.chain, motion_of(r.state.bit));
  std::complex<double> up[6]{}, down[6]{};
  for (int k = 0; k < 9000; ++k) {
    const double t = k * h, omega = r.state.chain.rotary_speed[probe];
    const double torque = 0.5 * (r.work.torque[probe - 1] + r.work.torque[probe]);
    for (std::size_t j = 0; j < 6; ++j) {
      const double w = 2.0 * pi * frequencies[j];
      const std::complex<double> turn = std::polar(1.0, -w * t);
      const double sharp = 1.0 / std::cos(0.5 * w * h);  // the mean of two elements is flatter
      up[j] += turn * (omega - sharp * torque / z);
      down[j] += turn * (omega + sharp * torque / z);
    }
    step_bit_on_chain(c, bit, h, {}, r.state, r.work);
  }
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_NEAR(std::abs(down[j] / up[j]), reflected[j], 4e-4);  // largest where it is 0
}

/// The flow of a limited drive: the torque never exceeds its limit, and the set angle stands still.
TEST(Top, a_torque_limit_bounds_the_motor_and_keeps_the_set_angle) {
  Top top = soft_top();
  top.torque_limit = 5e3;
  const TopFlow free = flow_top(soft_top(), 1e-3, 2.0, 6.0, 3.0, -1e3, 10.0, 2900.0);
  const TopFlow f = flow_top(top, 1e-3, 2.0, 6.0, 3.0, -1e3, 10.0, 2900.0);
  EXPECT_GT(free.motor_impulse, 1e-3 * 5e3);
  EXPECT_FALSE(free.limited);
  EXPECT_TRUE(f.limited);
  EXPECT_DOUBLE_EQ(f.motor_impulse, 5.0);
  EXPECT_DOUBLE_EQ(f.speed, 2.0 + mobility(1e-3, 2900.0, 10.0) * (5e3 - 1e3 - 10.0 * 2.0));
}

/// The bit takes 15 kN and 2e7 N s/m; the autodriller keeps 80 kN at the surface.
TEST(Top, an_autodriller_comes_to_the_rate_of_statics) {
  Chain c = make_chain(three_sections(), build_and_hold(), 0.25, 100);
  c.axial_damping = c.torsional_damping = 0.3;
  SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  bit.law = BitLaw::load;
  bit.weight = 15e3;
  bit.axial_damping += 2e7;
  bit.torque = 3e3;
  const double speed = 60.0 * rpm, wanted = 80e3;
  const auto loads = [&](double rate, double weight) {
    const double torque = bit.torsional_damping * speed + (weight > 0.0 ? bit.torque : 0.0);
    return steady_load(c, {rate, speed, bit.gravity_force - weight, torque});
  };
  c.top.tare = loads(0.0, 0.0).surface.hook_load;
  double lo = 0.0, hi = 1e-2;
  for (int k = 0; k < 60; ++k) {
    const double mid = 0.5 * (lo + hi);
    const double weight = c.top.tare - loads(mid, 15e3 + 2e7 * mid).surface.hook_load;
    (weight < wanted ? lo : hi) = mid;
  }
  const double torque = loads(lo, 15e3 + 2e7 * lo).surface.torque;
  EXPECT_NEAR(15e3 + 2e7 * lo, 79.183e3, 80.0);  // computed apart, to 1e-3
  EXPECT_NEAR(lo * 3600.0, 11.553, 0.012);
  EXPECT_NEAR(torque, 14.083e3, 14.0);

  c.top.axial = Top::Axial::autodriller;
  c.top.gain = 1e-6;
  c.top.integral_gain = 2e-7;
  c.top.filter = 0.5;
  c.top.largest_rate = 60.0 / 3600.0;
  const SteadyMotion off{0.0, speed, bit.gravity_force, 0.0};
  const SteadyStart start = steady_start(c, off, loads(0.0, 0.0));
  Running r = at_rest(c);
  r.state.chain = start.chain;
  r.state.bit.displacement = start.end.displacement;
  r.state.bit.angle = start.end.angle;
  r.state.bit.rotary_speed = speed;
  r.work = chain_work(c, r.state.chain, start.end);
  const double h = 4e-3;
  TopCommand command;
  command.turn = speed * h;
  command.weight = wanted;
  for (int k = 0; k < 40000; ++k) step_bit_on_chain(c, bit, h, command, r.state, r.work);
  EXPECT_NEAR(r.state.bit.velocity / lo, 1.0, 6e-5);
  EXPECT_NEAR(surface_load(c, r.state.chain, r.work).torque / torque, 1.0, 1.5e-8);
}

/// Slowest and fastest speed of the bit of well A (vertical, torsion, no mud) between 120 s and 150 s,
/// over that of the top.
std::pair<double, double> bit_speeds(const Top& top, double speed) {
  Chain c = make_chain(well_a_sections(), vertical(), 0.0, 100);
  const double h = 2e-3;
  c.directions = Directions::torsion;
  c.torsional_loss_time = 0.1 * h;
  c.top = top;
  SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  bit.law = BitLaw::two_level;
  bit.resting_torque = 8e3;
  bit.sliding_torque = 4e3;
  const SteadyMotion still{0.0, 0.0, 0.0, 7.95e3};
  const SteadyStart start = steady_start(c, still, steady_load(c, still));
  Running r = at_rest(c);
  r.state.chain = start.chain;
  r.state.bit.angle = start.end.angle;
  r.work = chain_work(c, r.state.chain, start.end);
  std::pair<double, double> speeds{1e9, -1e9};
  TopCommand command;
  command.turn = speed * h;
  for (int k = 0; k < 75000; ++k) {
    step_bit_on_chain(c, bit, h, command, r.state, r.work);
    if (k < 60000) continue;
    speeds.first = std::min(speeds.first, r.state.bit.rotary_speed / speed);
    speeds.second = std::max(speeds.second, r.state.bit.rotary_speed / speed);
  }
  return speeds;
}

TEST(Top, soft_torque_and_z_torque_end_stick_slip_where_they_can) {
  const double impedance = torsional_impedance(well_a_sections()[0]);
  Top soft, z;
  soft.torsion = z.torsion = Top::Torsion::pi;
  soft.inertia = z.inertia = 2900.0;
  tune_soft_torque(soft, impedance, 3.0, 0.226);
  tune_z_torque(z, impedance, 3.0, 0.2);
  z.integral = 300.0;
  const auto stiff_top = bit_speeds({}, 60.0 * rpm), soft_top_60 = bit_speeds(soft, 60.0 * rpm);
  EXPECT_LE(stiff_top.first, 0.15);  // nearly stops, or stops
  EXPECT_GE(stiff_top.second, 1.8);
  EXPECT_NEAR(soft_top_60.first, 0.83, 0.01);
  EXPECT_NEAR(soft_top_60.second, 1.19, 0.03);
  EXPECT_EQ(bit_speeds(soft, 30.0 * rpm).first, 0.0);
  EXPECT_GE(bit_speeds(z, 30.0 * rpm).first, 0.5);
}

}  // namespace tdbd::string::top_test

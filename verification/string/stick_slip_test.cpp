#include <gtest/gtest.h>

#include <cmath>

#include "reference/string/characteristics.hpp"
#include "string/modes.hpp"
#include "string/statics.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::stick_slip_test {

using std::numbers::pi;

/// A spring of 611.9 N m/rad, a bit of 288.6 kg m2 whose friction has two levels, N m.
struct Lumped {
  double resting, sliding;
};
constexpr double spring = 611.9, inertia = 288.6, speed = 60.0 * rpm;

/// Times of a cycle in s; the peak over the speed of the top.
struct Cycle {
  double stick, slip, peak;
  double period() const { return stick + slip; }
};

/// Closed form: the bit sticks until the spring has the resting torque; then it swings about the
/// sliding torque until its speed is 0 again.
Cycle closed_form(const Lumped& f) {
  const double w = std::sqrt(spring / inertia), excess = f.resting - f.sliding;
  const double swing = excess / (spring * speed) * w;  // amplitude over that of the top's speed
  return {2.0 * excess / (spring * speed), 2.0 * (pi - std::atan(swing)) / w,
          1.0 + std::hypot(1.0, swing)};
}

Cycle simulated(const Lumped& f, double h) {
  Section s;
  s.length = s.axial_rigidity = 1.0;
  s.torsional_rigidity = spring;
  Chain c = make_chain({s}, vertical(), 0.0, 1);
  c.directions = Directions::torsion;
  SimpleBit bit = bit_below(c, 1.0, inertia, 0.0);
  bit.law = BitLaw::two_level;
  bit.resting_torque = f.resting;
  bit.sliding_torque = f.sliding;
  Running r = at_rest(c);
  Cycle cycle{0.0, 0.0, 0.0};
  long switches = 0, stuck = 0, slipping = 0;  // the first cycle starts with an unloaded spring
  for (bool was_stuck = true; switches < 4;) {
    TopCommand command;
    command.turn = h * speed;
    step_bit_on_chain(c, bit, h, command, r.state, r.work);
    const bool stands = r.state.bit.rotary_speed == 0.0;
    if (stands != was_stuck) ++switches;
    was_stuck = stands;
    if (switches == 2) ++stuck;
    if (switches == 3) ++slipping;
    cycle.peak = std::max(cycle.peak, r.state.bit.rotary_speed / speed);
  }
  cycle.stick = static_cast<double>(stuck) * h;
  cycle.slip = static_cast<double>(slipping) * h;
  return cycle;
}

TEST(StickSlip, a_lumped_bit_has_the_cycle_of_the_closed_form) {
  const double h = 1e-3;
  for (const Lumped& f : {Lumped{4000.0, 2000.0}, Lumped{8000.0, 5200.0}}) {
    const Cycle exact = closed_form(f), found = simulated(f, h);
    EXPECT_NEAR(found.stick, exact.stick, 2.0 * h);
    EXPECT_NEAR(found.slip, exact.slip, 2.0 * h);
    EXPECT_NEAR(found.period(), exact.period(), h);
    EXPECT_NEAR(found.peak, exact.peak, 1e-3);
  }
  EXPECT_NEAR(closed_form({4000.0, 2000.0}).period(), 4.4651, 5e-5);
  EXPECT_NEAR(closed_form({8000.0, 5200.0}).period(), 4.6526, 5e-5);
}

/// Uniform pipe of 1000 m over a bit of 5 kg m2 with friction, from rest, at Courant number 1: the
/// chain and the method of characteristics.
TEST(StickSlip, a_distributed_string_moves_as_by_characteristics) {
  const Section pipe = drill_pipe(1000.0);
  const double end = 20.0;
  const auto difference = [&](int n) {
    Chain c = make_chain({pipe}, vertical(), 0.0, n);
    c.directions = Directions::torsion;
    SimpleBit bit = bit_below(c, 0.0, 5.0, 0.0);
    bit.law = BitLaw::two_level;
    bit.resting_torque = bit.sliding_torque = 1500.0;
    const double h = c.elements.length / torsional_wave_speed(pipe);
    reference::WaveRod rod{std::vector<double>(at(n), torsional_impedance(pipe)), h, 5.0, 1500.0,
                           1500.0};
    reference::WaveState waves = reference::uniform_waves(rod, 0.0, 0.0);
    Running r = at_rest(c);
    double square = 0.0;
    const long steps = std::lround(end / h);
    for (long k = 0; k < steps; ++k) {
      const double t = h * static_cast<double>(k + 1);
      const double top = 10.0 * std::pow(std::sin(0.5 * pi * std::min(t / 2.0, 1.0)), 2);
      TopCommand command;
      command.turn = h * top;
      step_bit_on_chain(c, bit, h, command, r.state, r.work);
      reference::advance_waves(rod, top, waves);
      square +=
          std::pow(r.state.bit.rotary_speed - waves.end_speed, 2) / static_cast<double>(steps);
    }
    return std::sqrt(square);
  };
  const double coarse = difference(100), fine = difference(200);
  EXPECT_LE(fine, 1.2e-2);  // of up to 20 rad/s
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

}  // namespace tdbd::string::stick_slip_test

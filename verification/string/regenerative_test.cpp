#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/types.hpp"
#include "reference/string/characteristics.hpp"
#include "string/statics.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::regenerative_test {

/// Growth (1/s) of what differs from steady drilling, by its largest size in two windows of a run.
struct Windows {
  double first, second, width;  ///< s
};

/// A regenerative bit that drills steadily but for a small push.
struct Drilling {
  Chain chain;
  SimpleBit bit;
  double rate, speed;
};

double growth(const Drilling& d, double h, const Windows& w) {
  const double depth = d.rate * d.bit.pitch / d.speed;
  const SteadyMotion motion{
      d.rate, d.speed,
      d.bit.gravity_force - d.bit.force_per_depth * depth - d.bit.axial_damping * d.rate,
      d.bit.torque_per_depth * depth + d.bit.torsional_damping * d.speed};
  const SteadyStart start = steady_start(d.chain, motion, steady_load(d.chain, motion));
  Running r = at_rest(d.chain);
  r.state.chain = start.chain;
  r.state.bit.displacement = start.end.displacement;
  r.state.bit.angle = start.end.angle;
  r.state.bit.velocity = d.rate * (1.0 + 1e-3);
  r.state.bit.rotary_speed = d.speed;
  start_cut(d.bit, depth, r.state.bit);
  r.work = chain_work(d.chain, r.state.chain, motion_of(r.state.bit));
  const TopCommand command{d.speed * h, d.rate * h, r.state.chain.top.hook_load, 0.0};
  double first = 0.0, second = 0.0;
  const long steps = std::lround((w.second + w.width) / h);
  for (long k = 0; k < steps; ++k) {
    step_bit_on_chain(d.chain, d.bit, h, command, r.state, r.work);
    const double t = h * static_cast<double>(k), size = std::abs(r.state.bit.velocity - d.rate);
    if (t >= w.first && t < w.first + w.width) first = std::max(first, size);
    if (t >= w.second) second = std::max(second, size);
  }
  return std::log(second / first) / (w.second - w.first);
}

/// Where growth passes zero, from values on both sides of an expected one.
template <class Growth>
double crossing(double expected, double share, const Growth& growth_at) {
  const double lo = expected * (1.0 - share), hi = expected * (1.0 + share);
  const double at_lo = growth_at(lo), at_hi = growth_at(hi);
  EXPECT_LT(at_lo * at_hi, 0.0);
  return lo + (hi - lo) * at_lo / (at_lo - at_hi);
}

/// The axial string of the non-dimensional model: length 1, wave speed 1.6.
struct AxialCase {
  Top::Axial top;
  double speed, critical;
};

Drilling axial_drilling(const AxialCase& a, double aggressiveness) {
  const double wave = 1.6;
  Section s;
  s.length = s.axial_rigidity = s.torsional_rigidity = s.inertia = s.contact_radius = 1.0;
  s.mass = 1.0 / (wave * wave);
  Drilling d;
  d.chain = make_chain({s}, vertical(), 0.0, 100);
  d.chain.directions = Directions::axial;
  d.chain.axial_damping = -std::log(0.7);
  d.chain.top.axial = a.top;
  d.bit = bit_below(d.chain, 0.0, 0.0, 0.0);
  d.bit.law = BitLaw::regenerative;
  d.bit.force_per_depth = aggressiveness / wave;
  d.bit.pitch = 1.0;
  d.rate = 1.0;
  d.speed = a.speed;
  return d;
}

/// Smallest critical aggressiveness by the rod's transfer function: 1 + K/1.6 (1 - e^(-s/speed))/Z = 0
/// for s = i w, Z = k coth k or k tanh k, k = sqrt(s^2 + a s)/1.6.
double exact_aggressiveness(const AxialCase& a) {
  double least = HUGE_VAL;
  std::complex<double> before;
  for (double w = 1e-3; w < 60.0; w += 2e-4) {
    const std::complex<double> s(0.0, w), k = std::sqrt(s * s - std::log(0.7) * s) / 1.6;
    const std::complex<double> z = a.top == Top::Axial::rate ? k / std::tanh(k) : k * std::tanh(k);
    const std::complex<double> g = (1.0 - std::exp(-s / a.speed)) / 1.6 / z;
    if (before.imag() * g.imag() < 0.0 && g.real() < 0.0 && std::abs(g - before) < 0.1) {
      const double x = before.imag() / (before.imag() - g.imag());
      least = std::min(least, -1.0 / (before.real() + x * (g.real() - before.real())));
    }
    before = g;
  }
  return least;
}

TEST(Regenerative, axial_chatter_of_a_string_begins_where_its_transfer_function_has_it) {
  for (const AxialCase& a :
       {AxialCase{Top::Axial::rate, 1.0, 1.7294}, AxialCase{Top::Axial::rate, 4.0, 2.1193},
        AxialCase{Top::Axial::hook_load, 2.0, 1.2380},
        AxialCase{Top::Axial::hook_load, 4.0, 2.4184}}) {
    const double exact = exact_aggressiveness(a);
    EXPECT_NEAR(exact, a.critical, 6e-5);
    const double found = crossing(exact, 0.01, [&](double k) {
      return growth(axial_drilling(a, k), 5.5e-3, {200.0, 380.0, 20.0});
    });
    EXPECT_NEAR(found / exact, 1.0, 2e-3);
  }
}

/// Two masses on springs: the lumped model with a state-dependent delay.
struct LumpedCase {
  double axial_damping, torsional_damping, critical;
};
constexpr double mass = 34000.0, inertia = 116.0, axial = 7e5, torsional = 938.0;
constexpr double cutting = 4.0 * 0.108 * 0.6 * 60e6, turning = 4.0 * 0.108 * 0.108 * 60e6 / 2.0;
constexpr double rate = 18.0 / 3600.0;

/// Determinant of the linearised equations at s = i w; the delay follows from the turn of a blade.
std::complex<double> determinant(const LumpedCase& l, double speed, double w) {
  const std::complex<double> s(0.0, w), e = 1.0 - std::exp(-s * (0.5 * std::numbers::pi / speed));
  const std::complex<double> a = mass * s * s + l.axial_damping * s + axial;
  const std::complex<double> b = inertia * s * s + l.torsional_damping * s + torsional;
  return 1.0 + e * (cutting / a - turning * rate / speed / b);
}

/// Critical speed near a guess: Newton in speed and frequency, by differences.
double exact_speed(const LumpedCase& l, double speed) {
  double w = std::sqrt(torsional / inertia), best = HUGE_VAL;
  for (double x = 0.2; x < 60.0; x += 0.01)
    if (std::abs(determinant(l, speed, x)) < best) best = std::abs(determinant(l, speed, w = x));
  for (int k = 0; k < 50; ++k) {
    const std::complex<double> f = determinant(l, speed, w);
    const std::complex<double> fs = (determinant(l, speed + 1e-6, w) - f) / 1e-6;
    const std::complex<double> fw = (determinant(l, speed, w + 1e-6) - f) / 1e-6;
    const double det = fs.real() * fw.imag() - fs.imag() * fw.real();
    speed -= (f.real() * fw.imag() - f.imag() * fw.real()) / det;
    w -= (fs.real() * f.imag() - fs.imag() * f.real()) / det;
  }
  return speed;
}

Drilling lumped_drilling(const LumpedCase& l, double speed) {
  Section s;
  s.length = 1.0;
  s.axial_rigidity = axial;
  s.torsional_rigidity = torsional;
  Drilling d;
  d.chain = make_chain({s}, vertical(), 0.0, 1);
  d.bit = bit_below(d.chain, mass, inertia, 0.0);
  d.bit.law = BitLaw::regenerative;
  d.bit.axial_damping = l.axial_damping;
  d.bit.torsional_damping = l.torsional_damping;
  d.bit.force_per_depth = cutting;
  d.bit.torque_per_depth = turning;
  d.bit.pitch = 0.5 * std::numbers::pi;
  d.rate = rate;
  d.speed = speed;
  return d;
}

TEST(Regenerative, a_lumped_bit_is_stable_from_the_root_of_the_quasi_polynomial_on) {
  for (const LumpedCase& l : {LumpedCase{1e5, 30.0, 14.2452}, LumpedCase{3e5, 60.0, 12.1718}}) {
    const double exact = exact_speed(l, l.critical);
    EXPECT_NEAR(exact, l.critical, 1e-4);
    const double found = crossing(exact, 0.003, [&](double speed) {
      return growth(lumped_drilling(l, speed), 1e-3, {100.0, 220.0, 5.0});
    });
    EXPECT_NEAR(found / exact, 1.0, 8e-4);
  }
}

TEST(Regenerative, rock_stays_where_it_was_under_a_bit_that_lifts_off) {
  constexpr double h = 0.01, lift = 5e-3, below = 5e-4, rounding = 1e-17;
  SimpleBit bit;
  bit.law = BitLaw::regenerative;
  bit.pitch = 1.0;
  BitState s;
  start_cut(bit, 0.0, s);
  s.rotary_speed = 1.0;
  s.velocity = -lift / h;
  drift_bit(bit, h, s);
  s.velocity = 0.0;
  for (int k = 0; k < 300; ++k) {
    drift_bit(bit, h, s);
    EXPECT_EQ(s.depth, 0.0);
  }
  s.velocity = (lift + below) / h;
  drift_bit(bit, h, s);
  EXPECT_NEAR(s.depth, below, rounding);
}

}  // namespace tdbd::string::regenerative_test

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

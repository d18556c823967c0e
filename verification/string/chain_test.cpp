#include "string/chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types.hpp"
#include "reference/string/chain_equations.hpp"
#include "string/statics.hpp"
#include "verification/battery/counted_memory.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::chain_test {

/// The build-and-hold well with mud, drilling steadily with 60 rpm and 3 mm/s.
struct Drilling {
  Chain chain;
  SimpleBit bit;
  SteadyLoad load;
  SteadyStart start;
  Running run;
};
constexpr double rate = 3e-3, speed = 60.0 * rpm;

Drilling drilling(int elements) {
  Drilling d;
  d.chain = make_chain(three_sections(), build_and_hold(), 0.25, elements);
  d.chain.axial_damping = d.chain.torsional_damping = 0.3;
  d.bit = bit_below(d.chain, 200.0, 1.5, 1500.0);
  d.bit.law = BitLaw::load;
  d.bit.weight = 80e3;
  d.bit.torque = 4e3;
  const double pull = d.bit.gravity_force - d.bit.weight - d.bit.axial_damping * rate;
  d.load =
      steady_load(d.chain, {rate, speed, pull, d.bit.torque + d.bit.torsional_damping * speed});
  d.start = steady_start(
      d.chain, {rate, speed, pull, d.bit.torque + d.bit.torsional_damping * speed}, d.load);
  d.run.state.chain = d.start.chain;
  d.run.state.bit.displacement = d.start.end.displacement;
  d.run.state.bit.angle = d.start.end.angle;
  d.run.state.bit.velocity = rate;
  d.run.state.bit.rotary_speed = speed;
  d.run.work = chain_work(d.chain, d.run.state.chain, d.start.end);
  return d;
}

void advance(Drilling& d, double h, long steps) {
  TopCommand command;
  command.way = rate * h;
  command.turn = speed * h;
  for (long k = 0; k < steps; ++k)
    step_bit_on_chain(d.chain, d.bit, h, command, d.run.state, d.run.work);
}

TEST(Chain, steady_drilling_keeps_the_profile_of_its_start) {
  Drilling d = drilling(220);
  const double h = 1e-3;
  const long steps = 20000;
  advance(d, h, steps);
  const double way = rate * h * steps, turn = speed * h * steps;
  double v = 0.0, w = 0.0, stretch = 0.0, twist = 0.0;
  const ChainState& now = d.run.state.chain;
  for (std::size_t i = 0; i < 220; ++i) {
    v = std::max(v, std::abs(now.velocity[i] - rate));
    w = std::max(w, std::abs(now.rotary_speed[i] - speed));
    stretch =
        std::max(stretch, std::abs(now.displacement[i] - way - d.start.chain.displacement[i]));
    twist = std::max(twist, std::abs(now.angle[i] - turn - d.start.chain.angle[i]));
  }
  EXPECT_LE(v, 2e-12);  // observed 6e-13 m/s
  EXPECT_LE(w, 5e-10);  // 1.7e-10 rad/s
  EXPECT_LE(stretch, 1.6e-13 * d.start.end.displacement);
  EXPECT_LE(twist, 4.5e-12 * std::abs(d.start.end.angle));
}

TEST(Chain, a_string_under_two_thirds_of_its_friction_never_moves) {
  const Chain c = make_chain(plain_build_and_hold(), build_and_hold(), 0.25, 100);
  SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  bit.law = BitLaw::load;
  // Hanging without torque; then the top is turned until it has two thirds of the friction torque.
  Chain turning = c;
  turning.directions = Directions::torsion;
  bit.directions = Directions::torsion;
  Running r = at_rest(turning);
  const double h = 2e-3;
  for (int k = 0; k < 10000; ++k) {
    TopCommand command;
    command.turn = k < 1000 ? 1e-3 : 0.0;
    step_bit_on_chain(turning, bit, h, command, r.state, r.work);
  }
  EXPECT_EQ(r.state.bit.angle, 0.0);
  EXPECT_EQ(r.state.chain.angle[99], 0.0);
  EXPECT_GT(r.work.torque[0], 100.0);
  EXPECT_GT(r.work.resting, 0);
}

/// From hanging at rest to steady motion: hook load and torque come to those of statics.
TEST(Chain, pulled_lowered_and_turned_it_comes_to_its_static_loads) {
  Chain c = make_chain(three_sections(), build_and_hold(), 0.25, 100);
  c.axial_damping = c.torsional_damping = 0.3;
  const SimpleBit bit = bit_below(c, 200.0, 1.5, 1500.0);
  const double h = 4e-3;
  for (const auto& [v, w] : {std::pair{-0.2, 0.0}, {0.2, 0.0}, {0.0, speed}, {0.2, speed}}) {
    const SteadyMotion hanging{0.0, 0.0, bit.gravity_force, 0.0};
    const SteadyStart start = steady_start(c, hanging, steady_load(c, hanging));
    Running r = at_rest(c);
    r.state.chain = start.chain;
    r.state.bit.displacement = start.end.displacement;
    r.work = chain_work(c, r.state.chain, start.end);
    TopCommand command;
    command.way = v * h;
    command.turn = w * h;
    for (int k = 0; k < 30000; ++k) step_bit_on_chain(c, bit, h, command, r.state, r.work);
    const SurfaceLoad found = surface_load(c, r.state.chain, r.work);
    const SurfaceLoad exact =
        steady_load(c, {v, w, bit.gravity_force - bit.axial_damping * v, bit.torsional_damping * w})
            .surface;
    EXPECT_NEAR(found.hook_load / exact.hook_load, 1.0, 9e-10);
    EXPECT_NEAR(found.torque, exact.torque, 1e-4);  // of 12.9 kN m
  }
}

/// The same nodes for the twin, whose nodes begin below the top.
reference::SlidingChain twin_of(const Chain& c, const SimpleBit& bit) {
  reference::SlidingChain t;
  t.axial = c.elements.axial;
  t.torsional = c.elements.torsional;
  const auto below = [](const std::vector<double>& x) {
    return std::vector<double>(x.begin() + 1, x.end());
  };
  t.mass = below(c.elements.mass);
  t.inertia = below(c.elements.inertia);
  t.mass.back() = bit.mass;
  t.inertia.back() = bit.inertia;
  t.weight = below(c.contact.weight);
  t.radius = below(c.contact.radius);
  t.friction = below(c.contact.sliding);
  t.bend = c.contact.a;
  t.mixed = c.contact.b;
  t.side = c.contact.c;
  t.element = c.contact.element;
  for (const int node : c.contact.node) t.node.push_back(node - 1);
  t.axial_damping = c.axial_damping;
  t.torsional_damping = c.torsional_damping;
  t.top_rate = 0.5;
  t.top_speed = 20.0;
  return t;
}

/// A chain that slides everywhere while waves run through it, from a start at which all nodes move at
/// one speed without any load.
Running sliding(const Chain& c, const SimpleBit& bit, double h, double end) {
  Running r = at_rest(c);
  std::fill(r.state.chain.velocity.begin(), r.state.chain.velocity.end(), 0.5);
  std::fill(r.state.chain.rotary_speed.begin(), r.state.chain.rotary_speed.end(), 20.0);
  r.state.bit.velocity = 0.5;
  r.state.bit.rotary_speed = 20.0;
  TopCommand command;
  command.way = 0.5 * h;
  command.turn = 20.0 * h;
  const long steps = std::lround(end / h);
  for (long k = 0; k < steps; ++k) step_bit_on_chain(c, bit, h, command, r.state, r.work);
  return r;
}

TEST(Chain, moves_as_its_equations_by_runge_kutta) {
  Chain c = make_chain(three_sections(), build_and_hold(), 0.2, 20);
  c.axial_damping = 0.3;
  c.torsional_damping = 0.2;
  SimpleBit bit = bit_below(c, 200.0, 1.5, 0.0);
  bit.axial_damping = c.axial_damping * bit.mass;  // the twin damps all nodes alike
  bit.torsional_damping = c.torsional_damping * bit.inertia;
  const double end = 1.6;
  reference::SlidingState exact;
  exact.displacement = exact.angle = std::vector<double>(20, 0.0);
  exact.velocity = std::vector<double>(20, 0.5);
  exact.rotary_speed = std::vector<double>(20, 20.0);
  reference::advance_sliding(twin_of(c, bit), 2.5e-4, std::lround(end / 2.5e-4), exact);
  const auto errors = [&](double h) {
    const Running r = sliding(c, bit, h, end);
    double u = 0.0, q = 0.0;
    for (std::size_t i = 1; i < 20; ++i) {
      u = std::max(u, std::abs(r.state.chain.displacement[i] - exact.displacement[i - 1]));
      q = std::max(q, std::abs(r.state.chain.angle[i] - exact.angle[i - 1]));
    }
    const double lost = std::abs(r.state.chain.ledger.friction / exact.lost - 1.0);
    return std::vector<double>{u, q, lost};
  };
  const auto coarse = errors(2e-3), fine = errors(1e-3);
  const double allowed[] = {6e-6, 9e-5, 1.5e-6};  // m of 0.9, rad of 32; of the friction's loss
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(fine[k], allowed[k]);
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 2.0, 0.03);
  }
}

/// Largest speed of the bit of a uniform rod that is shaken once, after many steps of a share of the
/// longest one.
double speed_after(double share, double loss_time) {
  Chain c = make_chain({drill_pipe(400.0)}, vertical(), 0.0, 20);
  c.directions = Directions::torsion;
  c.torsional_loss_time = loss_time;
  const SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  const double h = share * longest_step(c, bit.mass, bit.inertia);
  Running r = at_rest(c);
  r.state.bit.rotary_speed = 1.0;
  for (int k = 0; k < 20000; ++k) step_bit_on_chain(c, bit, h, {}, r.state, r.work);
  return std::abs(r.state.bit.rotary_speed);
}

TEST(Chain, the_longest_step_is_sharp_on_a_uniform_rod) {
  EXPECT_LE(speed_after(0.999, 0.0), 3.0);
  EXPECT_FALSE(speed_after(1.01, 0.0) < 1e6);
  EXPECT_LE(speed_after(0.99, 2e-3), 1.0);
  EXPECT_FALSE(speed_after(1.01, 2e-3) < 1e6);
}

}  // namespace tdbd::string::chain_test

namespace tdbd::string::chain_ledger_test {

enum class Kind { speed, top_drive, loss, regenerative };

struct System {
  Chain chain;
  SimpleBit bit;
};

System system_of(Kind kind) {
  System s;
  s.chain = make_chain(three_sections(), build_and_hold(), 0.25, 40);
  s.chain.axial_damping = s.chain.torsional_damping = 0.3;
  if (kind == Kind::top_drive) {
    s.chain.top.torsion = Top::Torsion::pi;
    s.chain.top.inertia = 2000.0;
    s.chain.top.proportional = 800.0;
    s.chain.top.integral = 900.0;
    s.chain.top.torque_limit = 6e3;
    s.chain.top.axial = Top::Axial::hook_load;
  }
  if (kind == Kind::loss) s.chain.axial_loss_time = s.chain.torsional_loss_time = 2e-3;
  s.bit = bit_below(s.chain, 200.0, 1.5, 1500.0);
  if (kind == Kind::regenerative) {
    s.bit.law = BitLaw::regenerative;
    s.bit.force_per_depth = 2e7;
    s.bit.torque_per_depth = 1e6;
    s.bit.contact_force = 1e4;
    s.bit.contact_lever = 0.05;
    s.bit.pitch = 2.0;
  } else {
    s.bit.law = BitLaw::two_level;
    s.bit.weight = 2e4;
    s.bit.resting_torque = s.bit.sliding_torque = 1500.0;
  }
  return s;
}

/// The top turns and lowers, stops and turns back: nodes slide, turn round and come to rest.
TopCommand command_at(double t, double h) {
  const auto angle = [](double x) { return 60.0 * x * std::exp(-0.5 * x); };
  TopCommand c;
  c.turn = angle(t + h) - angle(t);
  c.way = 0.02 * (std::sin(0.8 * (t + h)) - std::sin(0.8 * t));
  c.hook_load = 4.2e5 + 2e4 * std::sin(0.9 * t);
  return c;
}

Running started(const System& s) {
  Running r;
  const SteadyMotion hanging{0.0, 0.0, s.bit.gravity_force, 0.0};
  const SteadyStart start = steady_start(s.chain, hanging, steady_load(s.chain, hanging));
  r.state.chain = start.chain;
  r.state.bit.displacement = start.end.displacement;
  if (s.bit.law == BitLaw::regenerative) start_cut(s.bit, 1e-4, r.state.bit);
  r.work = chain_work(s.chain, r.state.chain, start.end);
  return r;
}

/// Largest change of the balance, J.
double residual(Kind kind, double h, double end) {
  const System s = system_of(kind);
  Running r = started(s);
  const double start = energy_balance(s.chain, s.bit, r.state);
  double worst = 0.0;
  const long steps = std::lround(end / h);
  for (long k = 0; k < steps; ++k) {
    step_bit_on_chain(s.chain, s.bit, h, command_at(h * static_cast<double>(k), h), r.state,
                      r.work);
    worst = std::max(worst, std::abs(energy_balance(s.chain, s.bit, r.state) - start));
  }
  return worst;
}

constexpr Kind kinds[] = {Kind::speed, Kind::top_drive, Kind::loss, Kind::regenerative};

TEST(ChainLedger, residual_is_of_second_order) {
  const double allowed[] = {9.0, 6.0, 7.0, 9.0};  // J
  for (std::size_t k = 0; k < 4; ++k) {
    const double coarse = residual(kinds[k], 2e-3, 6.0), fine = residual(kinds[k], 1e-3, 6.0);
    EXPECT_LE(fine, allowed[k]);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
  }
}

/// Some friction is not taken twice or lost: all kinds of losses are positive where they act.
TEST(ChainLedger, losses_are_positive) {
  for (const Kind kind : kinds) {
    const System s = system_of(kind);
    Running r = started(s);
    ChainLedger before;
    for (int k = 0; k < 3000; ++k) {
      step_bit_on_chain(s.chain, s.bit, 1e-3, command_at(1e-3 * k, 1e-3), r.state, r.work);
      const ChainLedger& now = r.state.chain.ledger;
      ASSERT_GE(now.friction, before.friction);
      ASSERT_GE(now.damping, before.damping);
      before = now;
    }
  }
}

/// The same run, interrupted once: state alone is kept.
TEST(ChainLedger, a_restart_continues_bitwise) {
  for (const Kind kind : kinds) {
    const System s = system_of(kind);
    Running whole = started(s), parts = started(s);
    for (int k = 0; k < 2000; ++k) {
      if (k == 777) {
        const BitOnChain saved = parts.state;
        parts = {saved, chain_work(s.chain, saved.chain, motion_of(saved.bit))};
      }
      const TopCommand command = command_at(1e-3 * k, 1e-3);
      step_bit_on_chain(s.chain, s.bit, 1e-3, command, whole.state, whole.work);
      step_bit_on_chain(s.chain, s.bit, 1e-3, command, parts.state, parts.work);
    }
    EXPECT_EQ(whole.state.chain.angle, parts.state.chain.angle);
    EXPECT_EQ(whole.state.chain.velocity, parts.state.chain.velocity);
    EXPECT_EQ(whole.state.bit.angle, parts.state.bit.angle);
    EXPECT_EQ(whole.state.chain.ledger.top, parts.state.chain.ledger.top);
    EXPECT_EQ(energy_balance(s.chain, s.bit, whole.state),
              energy_balance(s.chain, s.bit, parts.state));
  }
}

/// Without friction and dampers, steps of -h lead back.
TEST(ChainLedger, steps_without_friction_are_reversible) {
  Chain c = make_chain(three_sections(), build_and_hold(), 0.0, 40);
  const SimpleBit bit = bit_below(c, 200.0, 1.5, 1500.0);
  Running r = at_rest(c);
  const int steps = 20000;
  const double h = 2e-3;
  for (int k = 0; k < 2 * steps; ++k) {
    const double step = k < steps ? h : -h;
    TopCommand command;
    command.turn = 6.0 * step;
    command.way = 0.1 * step;
    step_bit_on_chain(c, bit, step, command, r.state, r.work);
  }
  double worst = 0.0;
  for (const double x : r.state.chain.displacement) worst = std::max(worst, std::abs(x));
  for (const double x : r.state.chain.angle) worst = std::max(worst, std::abs(x));
  EXPECT_LE(worst, 8e-12);
}

TEST(ChainLedger, a_warm_step_allocates_nothing) {
  const System s = system_of(Kind::loss);
  Running r = started(s);
  const auto advance = [&](int steps) {
    for (int k = 0; k < steps; ++k)
      step_bit_on_chain(s.chain, s.bit, 1e-3, command_at(1e-3 * k, 1e-3), r.state, r.work);
  };
  advance(3);
  battery::reset_peak();
  const long held = battery::counted_memory().held;
  advance(1000);
  EXPECT_EQ(battery::counted_memory().peak, held);
}

}  // namespace tdbd::string::chain_ledger_test

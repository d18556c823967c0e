#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "string/chain.hpp"
#include "string/statics.hpp"
#include "verification/battery/counted_memory.hpp"
#include "verification/string/wells.hpp"

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

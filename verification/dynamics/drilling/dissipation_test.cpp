#include "dynamics/drilling/dissipation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::dissipation_test {
namespace {

/// What is left of a state, and where its energy went.
struct Left {
  DrillingState state;
  EnergyLedger ledger;
};

Left left_after(const DrillingSystem& s, Sweep sweep, double time) {
  Left left{coupled_start(s), {}};
  Configuration at;
  configure(s, left.state, at);
  dissipate(s, at, sweep, time, left.state, left.ledger);
  return left;
}

/// Dampers of this size each, whatever their units.
DrillingSystem dampers_of(double size, DamperEnd end) {
  DrillingSystem s = coupled_bit(AxialMode::rate, end);
  s.string.damping = size * Mat3::Identity();
  s.string.turn_damping = size * Mat3::Identity();
  s.bearing_damping = {size, size};
  s.rock.damping = size;
  return make_drilling_system(s);
}

std::vector<double> losses(const EnergyLedger& l) {
  return {l.damped_string, l.damped_bearings, l.damped_rock};
}

void expect_same(const Left& a, const Left& b) {
  constexpr double rounding = 1e-13;  // of momenta and energies of some 100
  EXPECT_LT((a.state.momentum_W - b.state.momentum_W).norm(), rounding);
  EXPECT_LT((a.state.rotation.momentum_W - b.state.rotation.momentum_W).norm(), rounding);
  for (std::size_t k = 0; k < a.state.rotation.cone_momenta.size(); ++k)
    EXPECT_NEAR(a.state.rotation.cone_momenta[k], b.state.rotation.cone_momenta[k], rounding);
  EXPECT_NEAR(a.state.rock_momentum, b.state.rock_momentum, rounding);
  EXPECT_NEAR(a.ledger.top, b.ledger.top, rounding);
  for (std::size_t k = 0; k < losses(a.ledger).size(); ++k)
    EXPECT_NEAR(losses(a.ledger)[k], losses(b.ledger)[k], rounding) << k;
}

/// Twice the damping for half the time takes the same: a coefficient counts by its product with time,
/// and none of them is special, 1 least of all.
TEST(Dissipation, goes_with_coefficient_times_time) {
  for (const Sweep sweep : {Sweep::forward, Sweep::backward})
    for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
      const Left once = left_after(dampers_of(1.0, end), sweep, 0.2),
                 half = left_after(dampers_of(2.0, end), sweep, 0.1);
      expect_same(once, half);
      for (const double loss :
           {once.ledger.damped_string, once.ledger.damped_bearings, once.ledger.damped_rock})
        EXPECT_GT(loss, 1e-6);
      EXPECT_EQ(once.ledger.top == 0.0, end == DamperEnd::space);
    }
}

/// Rock that is held takes nothing, and nothing else is taken twice in its place.
TEST(Dissipation, is_the_same_beside_rock_that_is_held_or_loose) {
  DrillingSystem loose = dampers_of(1.0, DamperEnd::space), held = loose;
  loose.rock.damping = 0.0;
  held.rock.mass = 0.0;
  for (const Sweep sweep : {Sweep::forward, Sweep::backward}) {
    const Left a = left_after(loose, sweep, 0.2), b = left_after(held, sweep, 0.2);
    expect_same(a, b);
    EXPECT_EQ(b.ledger.damped_rock, 0.0);
  }
}

}  // namespace
}  // namespace tdbd::dynamics::dissipation_test

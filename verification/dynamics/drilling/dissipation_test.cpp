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
  EXPECT_GT(at.contact.depth, 0.0);
  dissipate(s, at, sweep, time, left.state, left.ledger);
  return left;
}

/// Dampers and friction of this size each, whatever their units, against a wall that gives all back.
DrillingSystem dampers_of(double size, DamperEnd end) {
  DrillingSystem s = coupled_bit(AxialMode::rate, end);
  s.string.damping = size * Mat3::Identity();
  s.string.turn_damping = size * Mat3::Identity();
  s.bearing_damping = {size, size};
  s.rock.damping = size;
  s.wall.friction = size;
  return make_drilling_system(s);
}

std::vector<double> losses(const EnergyLedger& l) {
  return {l.damped_string, l.damped_bearings, l.damped_rock, l.wall_loss, l.wall_friction};
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
      for (const double loss : {once.ledger.damped_string, once.ledger.damped_bearings,
                                once.ledger.damped_rock, once.ledger.wall_friction})
        EXPECT_GT(loss, 1e-6);
      EXPECT_EQ(once.ledger.wall_loss, 0.0);
      EXPECT_EQ(once.ledger.top == 0.0, end == DamperEnd::space);
    }
}

/// What a wall keeps grows with its stiffness and with the share of the energy that it does not give back.
TEST(Dissipation, at_the_wall_goes_with_what_it_does_not_give_back) {
  const auto wall = [](double stiffness, double restitution) {
    DrillingSystem s = dampers_of(0.0, DamperEnd::space);
    s.wall.stiffness = stiffness;
    s.wall.restitution = restitution;
    return make_drilling_system(s);
  };
  const Left soft = left_after(wall(2e5, 0.6), Sweep::forward, 1e-3);
  expect_same(soft, left_after(wall(4e5, 0.6), Sweep::forward, 5e-4));
  expect_same(soft, left_after(wall(4e5, std::sqrt(1.0 - 0.5 * 0.64)), Sweep::forward, 1e-3));
  EXPECT_GT(soft.ledger.wall_loss, 1e-3);
  EXPECT_EQ(left_after(wall(2e5, 1.0), Sweep::forward, 1e-3).ledger.wall_loss, 0.0);
}

/// Rock that is held takes nothing, and nothing else is taken twice in its place.
TEST(Dissipation, is_the_same_beside_rock_that_is_held_or_loose) {
  DrillingSystem loose = dampers_of(1.0, DamperEnd::space), held = loose;
  loose.rock.damping = 0.0;
  held.rock.mass = 0.0;
  for (const Sweep sweep : {Sweep::forward, Sweep::backward}) {
    const Left a = left_after(loose, sweep, 0.2), b = left_after(held, sweep, 0.2);
    expect_same(a, b);
    EXPECT_EQ(a.ledger.wall_friction, b.ledger.wall_friction);
    EXPECT_EQ(b.ledger.damped_rock, 0.0);
  }
}

/// A ring that stands off its wall feels none of it.
TEST(Dissipation, has_no_wall_where_the_ring_does_not_touch) {
  DrillingSystem s = dampers_of(1.0, DamperEnd::space);
  s.wall.clearance = 1.0;
  s.wall.restitution = 0.5;
  s = make_drilling_system(s);
  Left left{coupled_start(s), {}};
  Configuration at;
  configure(s, left.state, at);
  ASSERT_EQ(at.contact.depth, 0.0);
  dissipate(s, at, Sweep::forward, 0.2, left.state, left.ledger);
  EXPECT_EQ(left.ledger.wall_loss, 0.0);
  EXPECT_EQ(left.ledger.wall_friction, 0.0);
}

/// Not even rounding: a wall without friction leaves every bit where it is, however the ring slips.
RC_GTEST_PROP(Dissipation, by_friction_is_none_on_a_smooth_wall, ()) {
  DrillingSystem s = dampers_of(0.0, DamperEnd::space);
  s.wall.slip_speed = *battery::number(1e-3, 10.0);
  Left left{coupled_start(s), {}};
  left.state.momentum_W += *battery::point(100.0);
  const DrillingState before = left.state;
  Configuration at;
  configure(s, left.state, at);
  RC_ASSERT(at.contact.depth > 0.0);
  dissipate(s, at, Sweep::forward, 1e-3, left.state, left.ledger);
  RC_ASSERT(left.ledger.wall_friction == 0.0);
  RC_ASSERT(left.state.momentum_W == before.momentum_W);
  RC_ASSERT(left.state.rotation.momentum_W == before.rotation.momentum_W);
}

/// Where the ring lets go the wall presses with e^2 of its force, and so does friction.
TEST(Dissipation, by_friction_goes_with_what_presses) {
  const auto rubbed = [](double restitution, double outward) {
    DrillingSystem s = dampers_of(0.0, DamperEnd::space);
    s.wall.friction = 0.01;
    s.wall.slip_speed = 0.0;
    s.wall.restitution = restitution;
    s = make_drilling_system(s);
    Left left{coupled_start(s), {}};
    Configuration at;
    configure(s, left.state, at);
    left.state.momentum_W += outward * at.contact.outward_W;
    left.state.rotation.momentum_W.setZero();
    s.wall.stiffness *= 1e-3;  // too weak to turn the way back
    dissipate(s, at, Sweep::backward, 1e-3, left.state, left.ledger);  // friction first
    return left.ledger.wall_friction;
  };
  const double in = rubbed(1.0, 500.0), out = rubbed(1.0, -500.0);
  EXPECT_NEAR(rubbed(0.5, 500.0) / in, 1.0, 1e-12);
  EXPECT_NEAR(rubbed(0.5, -500.0) / out, 0.25, 8e-7);  // of second order in the impulse
}

}  // namespace
}  // namespace tdbd::dynamics::dissipation_test

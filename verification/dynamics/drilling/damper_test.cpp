#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/drilling/columns.hpp"
#include "dynamics/drilling/resisted_flow.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::damper_test {

constexpr double rounding = 1e-12;  ///< of the energies, speeds or ways involved

/// h D / M from a thousandth to a million: the speed falls as an exponential, whatever the step.
TEST(Damper, is_the_exponential_whatever_the_step) {
  for (double x = 1e-3; x < 2e6; x *= 10.0) {
    DrillingSystem s = plain_bit();
    s.string.damping = (x * s.mass * Mat3::Identity()).eval();  // h = 1 s
    s = make_drilling_system(s);
    DrillingState from = at_rest(s);
    from.momentum_W = Vec3(3.0, -5.0, 7.0);
    DrillingRun d = start(s, nullptr, from);
    const double start_energy = d.ledger.start;
    double energy = start_energy;
    for (int i = 0; i < 20; ++i) {
      step(s, nullptr, 1.0, d);
      const double now = total(stored_energy(s, d.work.at, d.state));
      EXPECT_LE(now, energy);
      energy = now;
      const double left = std::exp(-x * (i + 1));
      EXPECT_NEAR(d.state.momentum_W.norm(), from.momentum_W.norm() * left,
                  rounding * from.momentum_W.norm());
      EXPECT_NEAR(d.ledger.damped_string + now, start_energy, rounding * start_energy);
    }
  }
}

/// A weight lowered against a damper at its terminal velocity, and a lean that relaxes against one:
/// the step moves both as fast as the forces do, up to a thousand times the damping that it resolves.
/// An impulse of half a step would move them by (h D / 2 M) coth(h D / 2 M) as fast.
TEST(Damper, that_is_stiff_lets_the_bit_move_as_fast_as_the_force_does) {
  constexpr double h = 1e-3, load = 1e4, spring = 1e3;
  for (const double x : {0.1, 1.0, 10.0, 100.0, 1000.0}) {
    DrillingSystem s = plain_bit();
    s.gravity = 0.0;
    const double c = x * s.mass / h, turning = x * 8.0 / h;  // N s/m, N m s/rad
    s.string.damping.diagonal().z() = c;
    s.string.turn_damping.diagonal().head<2>().setConstant(turning);
    s.string.turn_stiffness.diagonal().head<2>().setConstant(spring);
    s.top.axial = AxialMode::load;
    s.top.load = constant(load);
    s = make_drilling_system(s);
    DrillingState from = at_rest(s);
    const double lean = 1e-3, fall = spring / turning;  // 1/s: where inertia is nothing
    const Mat3 R = Eigen::AngleAxisd(lean, Vec3::UnitX()).toRotationMatrix();
    from.rotation = make_state(s.gyrostat, R, Vec3(-fall * lean, 0.0, 0.0), {}, {});
    from.momentum_W.z() = s.mass * load / c;
    DrillingRun d = start(s, nullptr, from);
    constexpr int n = 100;
    for (int i = 0; i < n; ++i) step(s, nullptr, h, d);
    EXPECT_NEAR(d.state.c_W.z(), n * h * load / c, rounding * n * h * load / c) << x;
    // The rate r of the slow motion: I r^2 - turning r + spring = 0.
    const double r = 2.0 * spring / (turning + std::sqrt(turning * turning - 32.0 * spring));
    const double left = bit_pose(s, d.state).R.transpose().coeff(1, 2);
    constexpr double within = 2e-3;  // at x = 0.1, where h r is 1/80
    EXPECT_NEAR(std::asin(left) / lean, std::exp(-n * h * r), within * n * h * r) << x;
  }
}

/// A flow of a state without forces.
struct Flow {
  DrillingState state;
  EnergyLedger ledger;
};
Flow flow_of(const DrillingSystem& s, double time) {
  Flow f{coupled_start(s), {}};
  Configuration at;
  configure(s, f.state, at);
  FlowWork work;
  work.force = Eigen::VectorXd::Zero(freedoms(s));
  resisted_flow(s, at, time, f.state, &f.ledger, work);
  return f;
}

/// Dampers of this size each, whatever their units, beside no wall.
DrillingSystem dampers_of(double size, DamperEnd end) {
  DrillingSystem s = coupled_bit(AxialMode::rate, end);
  s.wall = {};
  s.string.damping = size * Mat3::Identity();
  s.string.turn_damping = size * Mat3::Identity();
  s.bearing_damping = {size, size};
  s.rock.damping = size;
  return make_drilling_system(s);
}

void expect_same(const Flow& a, const Flow& b) {
  constexpr double same = 1e-13;  // of momenta and energies of some 100
  EXPECT_LT((a.state.momentum_W - b.state.momentum_W).norm(), same);
  EXPECT_LT((a.state.rotation.momentum_W - b.state.rotation.momentum_W).norm(), same);
  for (std::size_t k = 0; k < a.state.rotation.cone_momenta.size(); ++k)
    EXPECT_NEAR(a.state.rotation.cone_momenta[k], b.state.rotation.cone_momenta[k], same);
  EXPECT_NEAR(a.state.rock_momentum, b.state.rock_momentum, same);
  EXPECT_NEAR(a.ledger.top, b.ledger.top, same);
  EXPECT_NEAR(a.ledger.damped_string, b.ledger.damped_string, same);
  EXPECT_NEAR(a.ledger.damped_bearings, b.ledger.damped_bearings, same);
  EXPECT_NEAR(a.ledger.damped_rock, b.ledger.damped_rock, same);
}

/// Twice the damping for half the time takes the same: a coefficient counts by its product with time.
TEST(Damper, acts_by_coefficient_times_time) {
  for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
    const Flow once = flow_of(dampers_of(1.0, end), 0.2), half = flow_of(dampers_of(2.0, end), 0.1);
    expect_same(once, half);
    for (const double loss :
         {once.ledger.damped_string, once.ledger.damped_bearings, once.ledger.damped_rock})
      EXPECT_GT(loss, 1e-6);
    EXPECT_EQ(once.ledger.top == 0.0, end == DamperEnd::space);
  }
}

/// Rock that is held takes nothing, and nothing else is taken twice in its place.
TEST(Damper, is_the_same_beside_rock_that_is_held_or_loose) {
  DrillingSystem loose = dampers_of(1.0, DamperEnd::space), held = loose;
  loose.rock.damping = 0.0;
  held.rock.mass = 0.0;
  const Flow a = flow_of(loose, 0.2), b = flow_of(held, 0.2);
  expect_same(a, b);
  EXPECT_EQ(b.ledger.damped_rock, 0.0);
}

/// A damper that follows the top works on a bit at rest; the rest of the work is lost.
TEST(Damper, to_the_top_takes_its_work_from_the_top) {
  DrillingSystem s = plain_bit();
  s.string.turn_damping.diagonal().z() = 50.0;
  s.string.damping.diagonal().z() = 4e3;
  s.string.damper_end = DamperEnd::top;
  s.top.speed = constant(12.0);
  s.top.rate = constant(0.01);
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, nullptr, 0.1, d);
  const double kept = 0.5 * 2.0 * 12.0 * 12.0 + 0.5 * 500.0 * 0.01 * 0.01;  // as much as is lost
  EXPECT_NEAR(d.ledger.top, 2.0 * kept, rounding * kept);
  EXPECT_NEAR(d.ledger.damped_string, kept, rounding * kept);
  EXPECT_NEAR(velocity(s, d.state).w_W.z(), 12.0, 1e-12);
}

}  // namespace tdbd::dynamics::damper_test

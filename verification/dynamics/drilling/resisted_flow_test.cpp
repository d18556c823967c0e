#include "dynamics/drilling/resisted_flow.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/observed_order.hpp"
#include "dynamics/drilling/stability.hpp"
#include "reference/dynamics/ode.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

namespace tdbd::dynamics::resisted_flow_test {

double kinetic(const DrillingSystem& s, const DrillingState& x) {
  const StoredEnergy e = stored_energy(s, Configuration{}, x);
  return e.translation + e.rotation + e.cones + e.rock;
}

/// One flow of a state under forces.
struct Flow {
  DrillingState state;
  EnergyLedger ledger;
  FlowWork work;
};
Flow flow_of(const DrillingSystem& s, const DrillingState& from, const Eigen::VectorXd& force,
             double time) {
  Flow f{from, {}, {}};
  Configuration at;
  configure(s, from, at);
  f.work.force = force;
  resisted_flow(s, at, time, f.state, &f.ledger, f.work);
  return f;
}

Eigen::VectorXd no_force(const DrillingSystem& s) { return Eigen::VectorXd::Zero(freedoms(s)); }

Eigen::VectorXd momenta(const DrillingSystem& s, const DrillingState& x) {
  Eigen::VectorXd p;
  momenta_column(s, x, p);
  return p;
}

/// Everything that resists at once, with dampers and walls of any size.
DrillingSystem resisting_bit() {
  DrillingSystem s =
      coupled_bit(AxialMode::rate, *rc::gen::element(DamperEnd::space, DamperEnd::top));
  const double x = std::pow(10.0, *battery::number(-3.0, 6.0));
  s.string.damping *= x;
  s.string.turn_damping *= x;
  for (double& d : s.bearing_damping) d *= x;
  s.rock.damping *= x;
  s.wall.restitution = *rc::gen::element(0.0, 0.5, 0.9, 1.0);
  s.wall.friction *= std::pow(10.0, *battery::number(-3.0, 1.0));
  s.wall.slip_speed = *rc::gen::element(0.0, 1e-6, 1e-3, 1.0);
  s.wall.clearance = *rc::gen::element(0.0, 1.0);  // 1 m: the ring does not touch
  return make_drilling_system(s);
}

/// Energy goes nowhere but into the losses, and no loss is negative, whatever the step.
RC_GTEST_PROP(ResistedFlow, only_takes_energy_and_accounts_for_it, ()) {
  const DrillingSystem s = resisting_bit();
  DrillingState x = coupled_start(s);
  x.c_W += *battery::point(0.01);
  x.momentum_W = *battery::point(100.0);
  x.rotation.momentum_W = *battery::point(50.0);
  Eigen::VectorXd force = no_force(s);
  for (int i = 0; i < force.size(); ++i) force[i] = *battery::number(-100.0, 100.0);
  const double time = std::pow(10.0, *battery::number(-6.0, 0.5));
  const Flow f = flow_of(s, x, force, time);
  const double before = kinetic(s, x), after = kinetic(s, f.state);
  const EnergyLedger& l = f.ledger;
  const double work = time * force.dot(f.work.mean);
  const double scale = before + after + std::abs(work) + std::abs(l.top);
  const double lost =
      l.damped_string + l.damped_bearings + l.damped_rock + l.wall_loss + l.wall_friction;
  const double damping = s.string.damping.maxCoeff() / s.mass * time;  // impulses' rounding
  const double slack = 1.5e-15 * (1.0 + damping) * scale;
  RC_ASSERT(std::abs(after - before - work - l.top + lost) <= slack);
  RC_ASSERT(l.wall_loss >= 0.0 && l.wall_friction >= 0.0);
  for (const double damped : {l.damped_string, l.damped_bearings, l.damped_rock})
    RC_ASSERT(damped >= -slack);
}

/// Bitwise: without resistance the flow is the kick.
TEST(ResistedFlow, is_the_kick_where_nothing_resists) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string.damping.setZero();
  s.string.turn_damping.setZero();
  s.bearing_damping.assign(2, 0.0);
  s.rock.damping = 0.0;
  s.wall.friction = 0.0;  // gives all back
  s = make_drilling_system(s);
  const DrillingState x = coupled_start(s);
  Eigen::VectorXd force = no_force(s);
  for (int i = 0; i < force.size(); ++i) force[i] = 100.0 / (3 + i);
  const Flow f = flow_of(s, x, force, 1e-3);
  EXPECT_EQ(momenta(s, f.state), Eigen::VectorXd(momenta(s, x) + 1e-3 * force));
  EXPECT_EQ(f.ledger.wall_loss, 0.0);
}

/// Not even rounding differs: neither a smooth wall that gives all back nor one that the ring does not
/// touch resists.
TEST(ResistedFlow, has_no_wall_where_it_is_smooth_or_far) {
  DrillingSystem none = coupled_bit(AxialMode::rate, DamperEnd::top);
  none.wall = {};
  DrillingSystem smooth = none, far = none;
  smooth.wall = {2e5, 0.0, 0.1, -0.02, 1.0, 0.0, 0.5};
  far.wall = {2e5, 1.0, 0.1, -0.02, 0.5, 0.2, 0.5};
  const DrillingState x = coupled_start(none);
  const Flow f = flow_of(none, x, no_force(none), 0.1);
  for (const DrillingSystem& s : {smooth, far}) {
    const Flow g = flow_of(s, x, no_force(s), 0.1);
    EXPECT_EQ(momenta(s, f.state), momenta(s, g.state));
    EXPECT_EQ(g.ledger.wall_friction, 0.0);
    EXPECT_EQ(g.ledger.wall_loss, 0.0);
  }
}

/// A velocity whose resistance is the force stays, up to a million times the damping that a step
/// resolves: F = C(u) u.
TEST(ResistedFlow, keeps_a_velocity_that_balances_the_force) {
  constexpr double time = 1e-3;
  for (const double z : {1e-3, 1.0, 1e3, 1e6})
    for (const double restitution : {1.0, 0.5}) {
      DrillingSystem s = plain_bit();
      const double c = z * s.mass / time;
      s.string.damping = coupled(Vec3(c, 2.0 * c, 3.0 * c), 0.2);
      s.string.turn_damping = coupled(Vec3(8.0, 5.0, 2.0) * z / time, 0.2);
      s.wall = {2e6, 0.0, 0.1, 0.05, restitution, 0.4, 1e-2};
      s = make_drilling_system(s);
      DrillingState x = at_rest(s);
      x.c_W.x() = 0.01;  // touches along x
      const Vec3 w(0.3, -0.2, 1.5), ring(0.0, 0.0, 0.05), touch(0.1, 0.0, 0.05);
      Vec3 v(0.0, 0.02, -0.01);
      v.x() = -w.cross(ring).x();  // the ring does not move along the radius
      x.momentum_W = s.mass * v;
      x.rotation.momentum_W = Vec3(8.0, 8.0, 2.0).cwiseProduct(w);
      Vec3 slip = v + w.cross(touch);
      slip.x() = 0.0;
      const double normal = mean_wall_stiffness(s.wall) * 0.01;
      const Vec3 rubbing = 0.4 * normal * std::tanh(slip.norm() / 1e-2) * slip.normalized();
      Eigen::VectorXd force(6);
      force << s.string.damping * v + rubbing, s.string.turn_damping * w + touch.cross(rubbing);
      const Flow f = flow_of(s, x, force, time);
      const double change = (momenta(s, f.state) - momenta(s, x)).norm() / momenta(s, x).norm();
      EXPECT_LT(change, 1e-13 * std::max(1.0, z)) << z;
      EXPECT_NEAR(f.ledger.wall_friction, time * rubbing.dot(slip),
                  4e-11 * std::max(1.0, z) * time * rubbing.dot(slip));
    }
}

/// k p where the ring moves in, e^2 k p where it moves out: what friction rubs goes with the force
/// that the wall presses with.
TEST(ResistedFlow, friction_goes_with_what_presses) {
  const auto rubbed = [](double restitution, double outward) {
    DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
    s.string.damping.setZero();
    s.string.turn_damping.setZero();
    s.wall = {200.0, 0.0, 0.1, -0.02, restitution, 0.01, 0.0};  // too weak to turn the way back
    s = make_drilling_system(s);
    DrillingState x = coupled_start(s);
    Configuration at;
    configure(s, x, at);
    x.momentum_W += outward * at.contact.outward_W;
    x.rotation.momentum_W.setZero();
    return flow_of(s, x, no_force(s), 1e-3).ledger.wall_friction;
  };
  EXPECT_NEAR(rubbed(0.5, 500.0) / rubbed(1.0, 500.0), 1.0, 1.2e-5);
  EXPECT_NEAR(rubbed(0.5, -500.0) / rubbed(1.0, -500.0), 0.25, 1.2e-5);
}

/// Twin of the flow at these positions, with the friction of each instant, by GSL.
Eigen::VectorXd twin(const DrillingSystem& s, const DrillingState& from,
                     const Eigen::VectorXd& force, double time) {
  Configuration at;
  configure(s, from, at);
  const double normal = mean_wall_stiffness(s.wall) * at.contact.depth;
  DrillingState x = from;
  const auto rate = [&](double, std::span<const double> y, std::span<double> dy) {
    for (int i = 0; i < 3; ++i) {
      x.momentum_W[i] = y[tdbd::at(i)];
      x.rotation.momentum_W[i] = y[tdbd::at(3 + i)];
    }
    x.rotation.cone_momenta = {y[6], y[7]};
    x.rock_momentum = y[8];
    DrillingVelocity v;
    velocity(s, at, x, v);
    const Vec3 arm = at.pull.arm_W, touch = at.contact.touch_arm_W;
    const Vec3 pull = -s.string.damping * point_velocity(v, arm);
    Vec3 slip = point_velocity(v, touch);
    slip -= slip.dot(at.contact.outward_W) * at.contact.outward_W;
    const Vec3 rub =
        -s.wall.friction * normal * std::tanh(slip.norm() / s.wall.slip_speed) * slip.normalized();
    const Vec3 turn = -s.string.turn_damping * v.w_W + arm.cross(pull) + touch.cross(rub);
    for (int i = 0; i < 3; ++i) {
      dy[tdbd::at(i)] = force[i] + pull[i] + rub[i];
      dy[tdbd::at(3 + i)] = force[3 + i] + turn[i];
    }
    for (int k = 0; k < 2; ++k)
      dy[tdbd::at(6 + k)] =
          force[6 + k] - s.bearing_damping[tdbd::at(k)] * v.cone_rates[tdbd::at(k)];
    dy[8] = force[8] - s.rock.damping * v.rock;
  };
  const Eigen::VectorXd p = momenta(s, from);
  std::vector<double> y(p.data(), p.data() + p.size());
  reference::integrate(rate, reference::OdeMethod::rk8pd, {1e-14, 1e-13}, 0.0, time, y);
  return Eigen::Map<const Eigen::VectorXd>(y.data(), p.size());
}

/// The exponential where the wall is smooth: one flow of any length is exact. The Lobatto method where
/// it rubs: of order 2 in the length of its flows.
TEST(ResistedFlow, converges_to_its_twin) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const DrillingState x = coupled_start(s);
  Eigen::VectorXd force = no_force(s);
  for (int i = 0; i < force.size(); ++i) force[i] = 300.0 / (2 + i);
  constexpr double time = 0.2;
  const Eigen::VectorXd exact = twin(s, x, force, time);
  std::vector<double> steps, errors;
  for (int n = 64; n <= 2048; n *= 2) {
    Flow f = flow_of(s, x, force, time / n);
    Configuration at;
    configure(s, x, at);
    for (int i = 1; i < n; ++i) resisted_flow(s, at, time / n, f.state, &f.ledger, f.work);
    steps.push_back(time / n);
    errors.push_back((momenta(s, f.state) - exact).norm() / exact.norm());
  }
  EXPECT_NEAR(least_squares_order(steps, errors), 2.0, 0.05);
  EXPECT_LT(errors.back(), 1.5e-7);
  s.wall.friction = 0.0;
  const Eigen::VectorXd smooth = twin(s, x, force, time);
  EXPECT_LT((momenta(s, flow_of(s, x, force, time).state) - smooth).norm(), 1e-12 * smooth.norm());
}

}  // namespace tdbd::dynamics::resisted_flow_test

namespace tdbd::dynamics::rock_mount_test {

constexpr double contact = 8.6e6;  ///< N/m

/// Elastic contact along z between the bit and the rock where it is now.
void elastic_contact(const DrillingSystem&, const DrillingState& s, const DrillingVelocity&,
                     Wrench& w) {
  w.force_W.z() = -contact * std::max(s.c_W.z() - s.rock_z, 0.0);
  w.rock_force = -w.force_W.z();
}

/// Worked example: a bit of 500 kg at 0.1 m/s meets free rock of 280 kg.
TEST(RockMount, action_equals_reaction_on_free_rock) {
  DrillingSystem s = plain_bit();
  s.rock.mass = 280.0;
  s = make_drilling_system(s);
  DrillingState start_state = at_rest(s);
  start_state.momentum_W.z() = 50.0;
  DrillingRun d = start(s, elastic_contact, start_state);
  constexpr double h = 1e-5;
  double contact_time = 0.0, worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    step(s, elastic_contact, h, d);
    if (d.wrench.rock_force > 0.0) contact_time += h;
    worst = std::max(worst, std::abs(d.state.momentum_W.z() + d.state.rock_momentum - 50.0));
  }
  constexpr double rounding = 1e-12;  // N s
  EXPECT_LE(worst, rounding);
  battery::record({"chapter2/moving-rock",
                   "momentum of bit and free rock, 50 N s, over an impact: largest change", worst,
                   "N s", fmt::format("<= {}", rounding),
                   worst <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
  EXPECT_NEAR(d.state.momentum_W.z() / s.mass, 0.1 * (500.0 - 280.0) / 780.0, 4e-8);
  EXPECT_NEAR(d.state.rock_momentum / s.rock.mass, 0.1 * 1000.0 / 780.0, 7.5e-8);
  const double reduced_mass = s.mass * s.rock.mass / (s.mass + s.rock.mass);
  EXPECT_NEAR(contact_time, std::numbers::pi * std::sqrt(reduced_mass / contact), 0.6 * h);
}

TEST(RockMount, held_rock_does_not_move) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingState start_state = at_rest(s);
  start_state.momentum_W.z() = 50.0;
  DrillingRun d = start(s, elastic_contact, start_state);
  for (int i = 0; i < 5000; ++i) step(s, elastic_contact, 1e-5, d);
  EXPECT_EQ(d.state.rock_z, 0.0);
  EXPECT_EQ(d.state.rock_momentum, 0.0);
  EXPECT_NEAR(d.state.momentum_W.z(), -50.0, 3e-5);  // it bounces back
}

}  // namespace tdbd::dynamics::rock_mount_test

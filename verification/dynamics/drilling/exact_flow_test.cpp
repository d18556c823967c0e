#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "dynamics/drilling/dissipation.hpp"
#include "reference/dynamics/ode.hpp"
#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::exact_flow_test {

constexpr double rounding = 1e-12;  ///< of the energies or speeds involved

double kinetic(const DrillingSystem& s, const DrillingState& x) {
  const StoredEnergy e = stored_energy(s, Configuration{}, x);
  return e.translation + e.rotation + e.cones + e.rock;
}

/// h D / M from a thousandth to a million: the speed falls as an exponential, whatever the step.
TEST(ExactFlow, damper_is_the_exponential_whatever_the_step) {
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

/// Everything that takes energy at once, with bodies, cones and steps of any size.
DrillingSystem resisting_bit() {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const double x = std::pow(10.0, *battery::number(-3.0, 6.0));
  s.string.damping *= x;
  s.string.turn_damping *= x;
  for (double& d : s.bearing_damping) d *= x;
  s.rock.damping *= x;
  s.wall.restitution = *battery::number(0.0, 1.0);
  s.wall.friction *= x;
  s.wall.slip_speed = *rc::gen::element(0.0, 1e-6, 1e-3, 1.0);
  return make_drilling_system(s);
}

RC_GTEST_PROP(ExactFlow, dampers_and_frictions_only_take_energy, ()) {
  const DrillingSystem s = resisting_bit();
  DrillingState x = coupled_start(s);
  x.c_W += *battery::point(0.01);
  x.momentum_W = *battery::point(100.0);
  x.rotation.momentum_W = *battery::point(50.0);
  Configuration at;
  configure(s, x, at);
  const double before = kinetic(s, x);
  EnergyLedger lost;
  const double h = std::pow(10.0, *battery::number(-6.0, 1.0));
  for (const Sweep sweep : {Sweep::forward, Sweep::backward}) dissipate(s, at, sweep, h, x, lost);
  const double slack = rounding * before;
  RC_ASSERT(lost.damped_string >= -slack && lost.damped_bearings >= -slack);
  RC_ASSERT(lost.damped_rock >= -slack && lost.wall_loss >= -slack && lost.wall_friction >= -slack);
  RC_ASSERT(std::abs(residual({0, kinetic(s, x)}, lost) - before) <= slack);
  RC_ASSERT(kinetic(s, x) <= before + slack);
}

/// A damper that follows the top works on a bit at rest; the rest of the work is lost.
TEST(ExactFlow, damper_to_the_top_takes_its_work_from_the_top) {
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

TEST(ExactFlow, coulomb_friction_stops_and_holds) {
  const Along a{0.3, 0.01};
  EXPECT_NEAR(friction_impulse(a, 10.0, 0.0, 1.0), -10.0, rounding);  // slows by 0.1 m/s
  EXPECT_NEAR(friction_impulse(a, 10.0, 0.0, 7.0), -30.0, rounding);  // stops
  EXPECT_EQ(friction_impulse({0.0, 0.01}, 10.0, 0.0, 1.0), 0.0);      // holds
  EXPECT_NEAR(friction_impulse({-0.3, 0.01}, 10.0, 0.0, 1.0), 10.0, rounding);
}

/// Twin: GSL on v' = -force mobility tanh(v / slip_speed), from creeping to a hundred slip speeds.
TEST(ExactFlow, regularised_friction_is_that_of_its_equation) {
  constexpr double slip = 1e-2, force = 3.0, mobility = 0.02;
  for (const double speed : {1e-12, 1e-4, 1e-2, 0.05, 1.0, -0.3})
    for (const double time : {1e-3, 0.1, 1.0, 20.0}) {
      std::vector<double> y{speed};
      reference::integrate(
          [&](double, std::span<const double> v, std::span<double> dv) {
            dv[0] = -force * mobility * std::tanh(v[0] / slip);
          },
          reference::OdeMethod::rk8pd, {1e-30, 1e-13}, 0.0, time, y);
      const double left = speed + mobility * friction_impulse({speed, mobility}, force, slip, time);
      EXPECT_NEAR(left, y[0], 1e-11 * std::abs(speed)) << speed << " m/s, " << time << " s";
    }
}

/// What two half steps do is what one step does.
RC_GTEST_PROP(ExactFlow, friction_of_two_half_times_is_that_of_the_whole, ()) {
  const Along a{*battery::number(-2.0, 2.0), *battery::number(0.01, 3.0)};
  const double force = *battery::number(0.0, 5.0), time = *battery::number(0.0, 4.0);
  const double slip = *rc::gen::element(0.0, 1e-3, 0.5);
  const double first = friction_impulse(a, force, slip, 0.5 * time);
  const Along middle{a.speed + a.mobility * first, a.mobility};
  const double both = first + friction_impulse(middle, force, slip, 0.5 * time);
  RC_ASSERT(std::abs(both - friction_impulse(a, force, slip, time)) <=
            rounding * (1.0 + std::abs(both)));
}

}  // namespace tdbd::dynamics::exact_flow_test

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "dynamics/drilling/dissipation.hpp"
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

/// All dampers at once, with bodies, cones and steps of any size.
DrillingSystem resisting_bit() {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const double x = std::pow(10.0, *battery::number(-3.0, 6.0));
  s.string.damping *= x;
  s.string.turn_damping *= x;
  for (double& d : s.bearing_damping) d *= x;
  s.rock.damping *= x;
  return make_drilling_system(s);
}

RC_GTEST_PROP(ExactFlow, dampers_only_take_energy, ()) {
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
  RC_ASSERT(lost.damped_rock >= -slack);
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

}  // namespace tdbd::dynamics::exact_flow_test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "core/observed_order.hpp"
#include "reference/dynamics/lumped_drilling.hpp"
#include "rotation/quaternion.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

namespace tdbd::dynamics::energy_ledger_test {

constexpr std::array names{"top",      "gravity",    "cut, bit", "cut, rock",    "string",
                           "bearings", "rock mount", "wall",     "wall friction"};
using Entries = std::array<double, names.size()>;

template <class E>
Entries entries(const E& e) {
  return {e.top,         e.gravity,       e.cut_bit,
          e.cut_rock,    e.damped_string, e.damped_bearings,
          e.damped_rock, e.wall_loss,     e.wall_friction};
}

/// Each entry against the integral of its power that the twin carries along.
TEST(EnergyLedger, every_entry_converges_to_the_twins_with_order_two) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  const DrillingState from = coupled_start(s);
  const Entries exact = entries(
      reference::lumped_drilling(s, smooth_law, reference::lumped_state(s, from), 0.8).energy);
  std::vector<double> steps;
  std::array<std::vector<double>, names.size()> errors;
  for (long n = 800; n <= 12'800; n *= 2) {
    DrillingRun d = start(s, smooth_law, from);
    for (long i = 0; i < n; ++i) step(s, smooth_law, 0.8 / static_cast<double>(n), d);
    steps.push_back(0.8 / static_cast<double>(n));
    const Entries found = entries(d.ledger);
    for (std::size_t e = 0; e < found.size(); ++e)
      errors[e].push_back(std::abs(found[e] - exact[e]));
  }
  for (std::size_t e = 0; e < names.size(); ++e) {
    if (exact[e] == 0.0) {
      EXPECT_EQ(errors[e].back(), 0.0) << names[e];  // restitution 1 loses nothing
      continue;
    }
    EXPECT_NEAR(least_squares_order(steps, errors[e]), 2.0, 0.04) << names[e];
    EXPECT_LT(errors[e].back(), 6e-6 * std::abs(exact[e])) << names[e];
  }
}

/// Each by its size, whatever its sign; what dampers and the wall took is no part of it.
TEST(EnergyLedger, throughput_is_the_sum_of_sizes) {
  for (int signs = 0; signs < 32; ++signs) {
    const auto sized = [signs](int k, double size) { return (signs >> k) % 2 == 0 ? size : -size; };
    const EnergyLedger l{.start = sized(0, 1.0),
                         .top = sized(1, 2.0),
                         .gravity = sized(2, 4.0),
                         .cut_bit = sized(3, 8.0),
                         .cut_rock = sized(4, 16.0),
                         .damped_string = 32.0,
                         .damped_bearings = 64.0,
                         .damped_rock = 128.0,
                         .wall_loss = 256.0,
                         .wall_friction = 512.0};
    EXPECT_EQ(throughput(l), 31.0) << signs;
  }
}

/// Constant forces and torques on bit, cones and rock.
const LumpedLaw steady = [](const auto&, const auto&, const auto&, Wrench& w) {
  w = {Vec3(5.0, -9.0, -8e3), Vec3(0.0, 0.0, -30.0), {2.0}, 8e3};
};

/// Falls under `steady`, with dampers of this size.
DrillingSystem falling_bit(double damping) {
  DrillingSystem s = plain_bit();
  s.gyrostat = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {{Vec3::UnitZ(), 0.1}});
  s.bearing_damping = {0.2 * damping};
  s.string.damping.diagonal() = damping * Vec3(90.0, 40.0, 3e3);
  s.string.turn_damping.diagonal() = damping * Vec3(3.0, 2.0, 5.0);
  s.rock = {0.7, 0.0, 1.5 * damping};
  s.gravity = 9.81;
  s.top = {{}, AxialMode::load, {}, constant(9e3)};
  return make_drilling_system(s);
}

double through(const EnergyLedger& l) { return std::abs(l.cut_bit) + l.top + l.cut_rock; }

TEST(EnergyLedger, closes_to_rounding_under_constant_forces_without_dampers) {
  const DrillingSystem s = falling_bit(0.0);
  DrillingRun d = start(s, steady, at_rest(s));
  for (int i = 0; i < 1000; ++i) step(s, steady, 0.01, d);
  EXPECT_GT(through(d.ledger), 1e4);
  EXPECT_NEAR(residual(s, d), 0.0, 1e-12 * through(d.ledger));
}

/// The mean velocity over a flow is not the drift's while the speed changes.
TEST(EnergyLedger, residual_under_constant_forces_with_dampers_is_of_second_order) {
  const DrillingSystem s = falling_bit(1.0);
  std::vector<double> steps, residuals;
  for (int n = 250; n <= 4000; n *= 2) {
    DrillingRun d = start(s, steady, at_rest(s));
    for (int i = 0; i < n; ++i) step(s, steady, 10.0 / n, d);
    EXPECT_GT(d.ledger.damped_rock, 1e4);
    steps.push_back(10.0 / n);
    residuals.push_back(std::abs(residual(s, d)) / through(d.ledger));
  }
  EXPECT_NEAR(least_squares_order(steps, residuals), 2.0, 0.05);
  EXPECT_LT(residuals.back(), 1e-10);
}

/// However long the step, once the bit falls at the speed at which dampers bear its load.
TEST(EnergyLedger, closes_to_rounding_at_the_terminal_speed) {
  const DrillingSystem s = falling_bit(1e3);
  DrillingRun d = start(s, steady, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, steady, 0.1, d);
  const double residual_then = residual(s, d), through_then = through(d.ledger);
  for (int i = 0; i < 100; ++i) step(s, steady, 0.1, d);
  EXPECT_NEAR(residual(s, d), residual_then, 1e-12 * (through(d.ledger) - through_then));
}

/// Half a million steps without anything that damps: the residual swings, it does not drift.
TEST(EnergyLedger, residual_stays_bounded) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string.damping.setZero();
  s.string.turn_damping.setZero();
  s.bearing_damping.clear();
  s.rock.damping = s.wall.friction = 0.0;
  s.top.speed = constant(8.0);
  s.top.rate = {};
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, coupled_start(s));
  double early = 0.0, late = 0.0;
  constexpr int steps = 500'000;
  for (int i = 0; i < steps; ++i) {
    step(s, nullptr, 5e-4, d);
    double& worst = i < steps / 2 ? early : late;
    worst = std::max(worst, std::abs(residual(s, d)));
  }
  EXPECT_LT(late, 1.1 * early);
  const double relative = std::max(early, late) / d.ledger.start;
  EXPECT_LE(relative, 1e-4);
  battery::record({"ours/drilling-energy",
                   "residual of the ledger over half a million steps, part of the energy", relative,
                   "1", "<= 1e-4",
                   relative <= 1e-4 ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// The lead's share: forces of several parts, each at its own point, add up to the wrench's work.
TEST(EnergyLedger, parts_share_the_work_of_the_wrench) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const std::array<Vec3, 3> forces{Vec3(10.0, 20.0, -500.0), Vec3(-90.0, 5.0, -700.0),
                                   Vec3(30.0, 60.0, -20.0)};
  const std::array<Vec3, 3> arms{Vec3(0.1, 0.0, 0.2), Vec3(-0.04, 0.09, 0.2), Vec3(0.0, -0.1, 0.1)};
  const LumpedLaw parts = [&](const auto&, const auto&, const auto&, Wrench& w) {
    for (std::size_t i = 0; i < forces.size(); ++i) {
      w.force_W += forces[i];
      w.torque_W += arms[i].cross(forces[i]);
    }
  };
  DrillingRun d = start(s, parts, coupled_start(s));
  constexpr double h = 1e-3;
  double shared = 0.0;
  for (int i = 0; i < 300; ++i) {
    step(s, parts, h, d);
    for (std::size_t p = 0; p < forces.size(); ++p)
      for (const DrillingVelocity* v : {&d.work.opening, &d.work.closing})
        shared += 0.5 * h * forces[p].dot(point_velocity(*v, arms[p]));
  }
  EXPECT_NEAR(shared, d.ledger.cut_bit, 1e-12 * std::abs(d.ledger.cut_bit));
}

/// The whole impulse of the cones' own spins at the step's end, none at its start; the ledger has
/// its work.
TEST(EnergyLedger, counts_cone_impulses_at_the_end_of_a_step) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.bearing_damping.assign(s.gyrostat.cones.size(), 0.0);
  DrillingRun d = start(s, nullptr, coupled_start(s));
  constexpr double h = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> before = d.state.rotation.cone_momenta;
    open_step(s, h, d, d.work);
    EXPECT_EQ(d.state.rotation.cone_momenta, before);
    EXPECT_EQ(predicted(s, h, d, d.work).rotation.cone_momenta, before);
    Wrench w;
    w.cones = {0.3, -0.2};
    w.cone_impulse = ConeImpulse::at_end;
    const double cut_before = d.ledger.cut_bit;
    close_step(s, h, w, d, d.work);
    double work = 0.0;
    for (std::size_t k = 0; k < w.cones.size(); ++k) {
      EXPECT_DOUBLE_EQ(d.state.rotation.cone_momenta[k], before[k] + h * w.cones[k]);
      work += h * w.cones[k] * d.work.closing.cone_rates[k];
    }
    EXPECT_NEAR(d.ledger.cut_bit - cut_before, work, 1e-14);
  }
  EXPECT_LT(std::abs(residual(s, d)), 3e-4 * std::abs(d.ledger.start));
}

}  // namespace tdbd::dynamics::energy_ledger_test

namespace tdbd::dynamics::oscillator_test {

using Coordinate = std::function<double(const DrillingSystem&, const DrillingState&)>;

/// Angular frequency of one coordinate about zero, from the times of its upward crossings.
double measured_frequency(const DrillingSystem& s, const DrillingState& from, double h,
                          double duration, const Coordinate& value) {
  DrillingRun d = start(s, nullptr, from);
  double first = -1.0, last = -1.0, before = value(s, d.state);
  int periods = -1;
  while (d.state.rotation.time < duration) {
    step(s, nullptr, h, d);
    const double now = value(s, d.state);
    if (before < 0.0 && now >= 0.0) {
      last = d.state.rotation.time - h * now / (now - before);
      if (++periods == 0) first = last;
    }
    before = now;
  }
  return 2.0 * std::numbers::pi * periods / (last - first);
}

/// The number to be reached.
constexpr double allowed = 1e-3;

void record_deviation(const char* what, double relative, double limit) {
  EXPECT_LE(relative, limit);
  battery::record({"chapter2/drill-string", what, relative, "1", fmt::format("<= {}", limit),
                   relative <= limit ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// What the step makes of an angular frequency: (2/h) asin(h omega / 2), order 2.
double stepped_frequency(double omega, double h) { return 2.0 / h * std::asin(0.5 * h * omega); }

TEST(Oscillator, axial_and_lateral_frequencies_are_those_of_mass_on_spring) {
  DrillingSystem s = plain_bit();
  s.string.stiffness = Vec3(4e5, 5e5, 7e5).asDiagonal();
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W = Vec3(10.0, 20.0, 30.0);
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double exact = std::sqrt(s.string.stiffness(i, i) / s.mass);
    const Coordinate place = [i](const auto&, const DrillingState& x) { return x.c_W[i]; };
    for (const double h : {1e-3, 5e-4, 1e-4}) {
      const double found = measured_frequency(s, from, h, 2.0, place);
      worst = std::max(worst, std::abs(found / exact - 1.0));
      EXPECT_NEAR(found, stepped_frequency(exact, h), 4.5e-8 * exact);
    }
  }
  record_deviation("axial and lateral frequencies at steps up to 1 ms: largest relative deviation",
                   worst, 1.5e-4);
}

/// The top turns ten times while the bit swings after it.
TEST(Oscillator, torsional_pendulum_keeps_its_frequency_through_windings) {
  DrillingSystem s = plain_bit();
  s.string.turn_stiffness.diagonal().z() = 938.0;
  s.top.speed = constant(4.0 * std::numbers::pi);
  s = make_drilling_system(s);
  const double exact = std::sqrt(938.0 / 2.0);
  const Coordinate behind_top = [](const DrillingSystem& system, const DrillingState& x) {
    return rotation::twist_angle(x.rotation.q_WB, x.rotation.turns) - top_position(system, x).angle;
  };
  double worst = 0.0;
  for (const double h : {1e-3, 5e-4, 1e-4}) {
    const double found = measured_frequency(s, at_rest(s), h, 5.0, behind_top);
    worst = std::max(worst, std::abs(found / exact - 1.0));
    EXPECT_NEAR(found, stepped_frequency(exact, h), 6e-11 * exact);
  }
  record_deviation("torsional pendulum below a turning top: largest relative deviation", worst,
                   5e-5);
}

/// Hung by a stiff pin above its centre of mass the bit is a physical pendulum,
/// omega^2 = M g l / (I + M l^2).
TEST(Oscillator, bit_hung_above_its_centre_swings_as_a_pendulum) {
  constexpr double l = 0.5;
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.attachment_B = Vec3(0.0, 0.0, -l);
  s.string.stiffness = (1e8 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  s.string.rest_W = hanging_rest_W(s, from);
  from.rotation.momentum_W.x() = 1e-3 * 8.0;  // turns about x at 1e-3 rad/s,
  from.momentum_W.y() = -1e-3 * l * s.mass;   // about the pin
  const double exact = std::sqrt(s.mass * s.gravity * l / (8.0 + s.mass * l * l));
  const Coordinate aside = [](const auto&, const DrillingState& x) { return x.c_W.y(); };
  EXPECT_NEAR(measured_frequency(s, from, 1e-4, 5.0, aside), exact, 1.2e-4 * exact);
}

TEST(Oscillator, static_weight_stretches_the_string) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness = (7e5 * Mat3::Identity()).eval();
  s.string.damping = (4e4 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 10000; ++i) step(s, nullptr, 1e-4, d);
  EXPECT_NEAR(d.state.c_W.z(), 500.0 * 9.81 / 7e5, 1e-12);
}

/// Mass, spring and damper from rest under F cos(w t): both parts of the closed form.
double forced(double t, double M, double D, double K, double F, double w) {
  const double decay = 0.5 * D / M, ringing = std::sqrt(K / M - decay * decay);
  const double a = K - M * w * w, b = D * w, size = F / (a * a + b * b);
  const double p0 = size * a, v0 = size * b * w;  // the steady part and its speed at the start
  const double steady = size * (a * std::cos(w * t) + b * std::sin(w * t));
  const double free = -std::exp(-decay * t) * (p0 * std::cos(ringing * t) +
                                               (v0 + decay * p0) / ringing * std::sin(ringing * t));
  return steady + free;
}

TEST(Oscillator, forced_and_damped_motion_is_the_closed_form_with_order_two) {
  constexpr double K = 7e5, D = 3e3, F = 1e4, w = 31.0;
  DrillingSystem s = plain_bit();
  s.string.stiffness.diagonal().z() = K;
  s.string.damping.diagonal().z() = D;
  s = make_drilling_system(s);
  const LumpedLaw shakes = [](const auto&, const DrillingState& x, const auto&, Wrench& wrench) {
    wrench.force_W.z() = F * std::cos(w * x.rotation.time);
  };
  std::vector<double> steps, errors;
  for (int n = 400; n <= 12'800; n *= 2) {
    const double h = 2.0 / n;
    DrillingRun d = start(s, shakes, at_rest(s));
    double worst = 0.0;
    for (int i = 0; i < n; ++i) {
      step(s, shakes, h, d);
      const double exact = forced(d.state.rotation.time, s.mass, D, K, F, w);
      worst = std::max(worst, std::abs(d.state.c_W.z() - exact));
    }
    steps.push_back(h);
    errors.push_back(worst);
  }
  EXPECT_NEAR(least_squares_order(steps, errors), 2.0, 4e-4);
  EXPECT_LT(errors.back(), 9e-5 * F / K);
}

}  // namespace tdbd::dynamics::oscillator_test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/observed_order.hpp"
#include "rotation/swing_twist.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

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

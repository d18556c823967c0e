#include <gtest/gtest.h>

#include <numbers>

#include "rotation/swing_twist.hpp"
#include "verification/dynamics/drilling_run.hpp"

namespace tdbd::dynamics {
namespace {

constexpr double h = 1e-4;  ///< s

/// Angular frequency of one coordinate about `middle`, from the times of its upward crossings.
double measured_frequency(const DrillingSystem& s, const DrillingState& from, double duration,
                          double middle, const std::function<double(const DrillingState&)>& value) {
  Drilling d = start(s, nullptr, from);
  double first = -1.0, last = -1.0, before = value(d.state) - middle;
  int periods = -1;
  while (d.state.rotation.time < duration) {
    step(s, nullptr, h, d);
    const double now = value(d.state) - middle;
    if (before < 0.0 && now >= 0.0) {
      last = d.state.rotation.time - h * now / (now - before);
      if (++periods == 0) first = last;
    }
    before = now;
  }
  return 2.0 * std::numbers::pi * periods / (last - first);
}

/// The number that the issue asks for.
constexpr double allowed = 1e-3;

TEST(Oscillator, axial_and_lateral_frequencies_are_those_of_mass_on_spring) {
  DrillingSystem s = plain_bit();
  s.string.stiffness = Vec3(4e5, 5e5, 7e5).asDiagonal();
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W = Vec3(10.0, 20.0, 30.0);
  for (int i = 0; i < 3; ++i) {
    const double exact = std::sqrt(s.string.stiffness(i, i) / s.mass);
    EXPECT_NEAR(
        measured_frequency(s, from, 2.0, 0.0, [&](const DrillingState& x) { return x.c_W[i]; }),
        exact, 0.1 * allowed * exact);
  }
}

TEST(Oscillator, torsional_pendulum_keeps_its_frequency_through_windings) {
  DrillingSystem s = plain_bit();
  s.string.turn_stiffness.diagonal().z() = 938.0;
  s.top.speed = constant(4.0 * std::numbers::pi);
  s = make_drilling_system(s);
  const DrillingState from = at_rest(s);  // the top turns ten times while the bit swings after it
  const double exact = std::sqrt(938.0 / 2.0);
  const auto behind_top = [&](const DrillingState& x) {
    return rotation::twist_angle(x.rotation.q_WB, x.rotation.turns) -
           top_position(s, x.rotation.time).angle;
  };
  EXPECT_NEAR(measured_frequency(s, from, 5.0, 0.0, behind_top), exact, 0.1 * allowed * exact);
}

TEST(Oscillator, static_weight_stretches_the_string) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness = (7e5 * Mat3::Identity()).eval();
  s.string.damping = (4e4 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  Drilling d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 10000; ++i) step(s, nullptr, h, d);
  EXPECT_NEAR(d.state.c_W.z(), 500.0 * 9.81 / 7e5, 1e-12);
}

}  // namespace
}  // namespace tdbd::dynamics

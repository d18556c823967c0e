#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/evidence.hpp"
#include "claims/carry.hpp"
#include "reference/dynamics/jointed_bodies.hpp"

namespace tdbd::claims::equations_test {

using battery::Verdict;

/// An eighth-order composition and a Runge-Kutta method over the time below; scale: 1 rad, 1 rad/s. The more cones,
/// the more rounding.
constexpr double agreement = 7e-12, agreement_of_three = 2.5e-12;
constexpr double duration = 3.0;  // s
constexpr long steps = 300;
constexpr dynamics::Integrator best{dynamics::Drift::split, 1, 8};

reference::JointedCone cone(std::size_t k) {
  const double n = static_cast<double>(k), azimuth = 0.1 + 2.0 * std::numbers::pi * n / 5.0;
  reference::JointedCone c;
  c.mass = 0.3 + 0.05 * n;
  c.axis_B = Vec3(0.8 * std::cos(azimuth), 0.8 * std::sin(azimuth), 0.6);
  c.bearing_B = Vec3(0.1 * std::cos(azimuth), 0.1 * std::sin(azimuth), 0.2);
  c.offset = 0.15;
  c.axial_inertia = 0.05 + 0.01 * n;
  c.transverse_inertia = 0.7 * c.axial_inertia;
  return c;
}

/// A heavy unsymmetric body on a pin, with unequal cones, torques on it and on them.
reference::JointedBit bit(std::size_t cones) {
  reference::JointedBit b;
  b.body.mass = 3.0;
  b.body.centre_B = Vec3(0.05, -0.02, 0.3);
  b.body.inertia_B << 1.5, 0.1, 0.0, 0.1, 1.8, -0.05, 0.0, -0.05, 2.1;
  b.mount = reference::Mount::pinned;
  b.gravity = -4.0;
  b.torque_B = Vec3(0.3, -0.2, 0.5);
  for (std::size_t k = 0; k < cones; ++k) {
    b.cones.push_back(cone(k));
    b.loads.push_back({0.1 - 0.05 * static_cast<double>(k), 0.04, 0.0});
  }
  return b;
}

reference::JointedState thrown(std::size_t cones) {
  reference::JointedState s;
  s.R_WB = Mat3(Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()));
  s.w_B = Vec3(0.7, -0.5, 2.0);
  for (std::size_t k = 0; k < cones; ++k)
    s.spins.push_back((k % 2 == 0 ? -7.0 : 4.0) + static_cast<double>(k));
  return s;
}

/// Largest difference of attitude, angular velocity, angles and momenta between the program's
/// motion and that of separate rigid bodies in bearings.
double disagreement(std::size_t cones) {
  const reference::JointedBit b = bit(cones);
  const reference::JointedState start = thrown(cones);
  const auto [gyrostat, loads] = reference::equivalent(b);
  const std::vector<double> angles(cones, 0.0);
  const auto first = dynamics::make_state(gyrostat, start.R_WB, start.w_B, start.spins, angles);
  const auto ours = carry_to(gyrostat, loads, best, first, duration, steps).state;
  const auto bodies = reference::jointed_run(b, start, duration, {1e-13, 1e-13}).state;
  double worst = attitude_error(ours.q_WB.toRotationMatrix(), bodies.R_WB);
  worst = std::max(worst, (dynamics::angular_velocity(gyrostat, ours) - bodies.w_B).norm());
  for (std::size_t k = 0; k < cones; ++k)
    worst = std::max({worst, std::abs(ours.cone_angles[k] - bodies.cone_angles[k]),
                      std::abs(ours.cone_momenta[k] - bodies.cone_momenta[k])});
  return worst;
}

void check(const std::string& claim, std::size_t cones, double limit) {
  const double worst = disagreement(cones);
  EXPECT_LE(worst, limit) << cones << " cones";
  battery::record(
      {claim,
       fmt::format(
           "number of cones {}, heavy, torques on body and cones: largest difference from separate "
           "rigid bodies in bearings (constraint forces as multipliers) after {} s",
           cones, duration),
       worst, "rad, rad/s, N m s", fmt::format("<= {}", limit),
       worst <= limit ? Verdict::holds : Verdict::refuted});
}

TEST(EquationsOfMotion, are_those_of_body_and_cones_in_bearings) {
  check("chapter5/equations", 3, agreement_of_three);
}

TEST(EquationsOfMotion, are_satisfied_for_any_number_of_cones) {
  for (const std::size_t cones : {0u, 1u, 2u, 5u, 7u})
    check("chapter5/any-number-of-cones", cones, agreement);
}

}  // namespace tdbd::claims::equations_test

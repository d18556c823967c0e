#include "reference/literature/roller/wheel/briggs_wedge.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "battery/generators.hpp"
#include "core/angles.hpp"

namespace tdbd::reference::briggs_wedge_test {
namespace {

constexpr double printed = 1e-5;  // relative: six digits of the worked numbers

/// Mancos shale.
const CoulombRock shale{24.82e6, 23.8 * degree};

double between(double lo, double hi) { return lo + (hi - lo) * *battery::number(0.0, 1.0); }

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(BriggsWedge, pressures_are_the_worked_ones) {
  constexpr std::array angles{0.0, 20.0, 30.0, 45.0, 90.0};                    // degrees
  constexpr std::array pressures{76.148, 123.897, 153.884, 208.479, 473.050};  // MPa
  for (std::size_t i = 0; i < angles.size(); ++i)
    expect_near(wedge_pressure(shale, angles[i] * degree) / 1e6, pressures[i], printed);
}

TEST(BriggsWedge, a_sharp_one_meets_the_unconfined_strength) {
  const double sine = std::sin(shale.friction_angle), cosine = std::cos(shale.friction_angle);
  expect_near(wedge_pressure(shale, 0.0), 2.0 * shale.cohesion * cosine / (1.0 - sine), 1e-14);
}

TEST(BriggsWedge, a_flat_one_is_prandtls_punch) {
  const double phi = shale.friction_angle;
  const double Nq = std::exp(pi * std::tan(phi)) * std::pow(std::tan(pi / 4.0 + phi / 2.0), 2.0);
  expect_near(wedge_pressure(shale, right_angle), shale.cohesion * (Nq - 1.0) / std::tan(phi),
              1e-13);
}

TEST(BriggsWedge, without_friction_is_2c_times_one_and_its_angle) {
  for (const double phi : {0.0, 1e-10, 1e-8, 1e-6})
    expect_near(wedge_pressure({1e7, phi}, 0.5), 3e7, 1e-8 + 2.0 * phi);
}

RC_GTEST_PROP(BriggsWedge, cohesion_from_pressure_undoes_pressure_from_cohesion, ()) {
  const double phi = between(0.0, 0.8), b = between(0.0, right_angle), c = between(1e6, 1e8);
  RC_ASSERT(std::abs(wedge_cohesion(wedge_pressure({c, phi}, b), phi, b) / c - 1.0) < 1e-14);
}

TEST(BriggsWedge, the_worked_tooth_carries_the_worked_load_and_does_the_worked_work) {
  const WedgeTooth tooth{30.0 * degree, 10e-3};
  const double p = wedge_pressure(shale, tooth.half_angle);
  expect_near(wedge_load(tooth, p, 2e-3), 3553.8, 2e-5);
  expect_near(wedge_work(tooth, p, 2e-3), 3.5538, 2e-5);
  expect_near(wedge_depth(tooth, p, wedge_load(tooth, p, 2e-3)), 2e-3, 1e-14);
}

TEST(BriggsWedge, its_work_is_the_integral_of_its_load) {
  const WedgeTooth tooth{0.4, 8e-3};
  const double h = 1e-6;
  expect_near((wedge_work(tooth, 1e8, 1e-3 + h) - wedge_work(tooth, 1e8, 1e-3 - h)) / (2.0 * h),
              wedge_load(tooth, 1e8, 1e-3), 1e-9);
}

TEST(BriggsWedge, a_rigid_sprocket_has_the_worked_rise_pitch_and_drag) {
  const RigidSprocket s = rigid_sprocket(60e-3, 12);
  expect_near(s.rise, 2.04445e-3, printed);
  expect_near(s.pitch, 31.0583e-3, printed);
  expect_near(s.most_drag, 0.26795, 2.0 * printed);
  expect_near(s.mean_drag, 0.065826, printed);
  expect_near(s.mean_drag, s.rise / s.pitch, 1e-13);  // each rise is lost
}

TEST(BriggsWedge, a_smooth_wheel_has_the_worked_drag) {
  expect_near(std::sqrt(2e-3 / (2.0 * 60e-3)), 0.12910, 2.0 * printed);
  EXPECT_NEAR(smooth_wheel_drag(60e-3, 2e-3), 0.12910, 0.01 * 0.12910);
  EXPECT_NEAR(smooth_wheel_drag(60e-3, 2e-6), std::sqrt(1e-3 / 60.0), 1e-5 * 0.004);
}

/// The torque law of roller bits that this resistance explains, M/(W D) = a1 + a2 sqrt(R/(N D)), with the
/// constants that the field quotes for it. From memory (0.85), so a test only.
TEST(BriggsWedge, the_torque_law_of_the_field_has_the_same_root) {
  const double diameter = 8.5, weight = 20.0, speed = 90.0, rate = 20.0;  // in, klbf, rpm, ft/h
  const double root = std::sqrt(rate / (speed * diameter));
  const double torque = (3.79 + 19.17 * root) * diameter * weight;  // ft lbf
  EXPECT_NEAR(torque, 1171.0, 0.5);
  EXPECT_NEAR(36.0 * torque / (diameter * 1e3 * weight), 0.248, 5e-4);
  // R/(N D) of equal units is a fifth of that in ft/h, rpm and in.
  const double a1 = 3.79 * 12e-3, a2 = 19.17 * 12e-3 / std::sqrt(0.2);
  EXPECT_NEAR(a1, 0.0455, 5e-5);
  EXPECT_NEAR(a2, 0.514, 5e-4);
  EXPECT_NEAR(a1 + a2 * std::sqrt(0.2) * root, torque / (diameter / 12.0 * 1e3 * weight), 1e-12);
}

}  // namespace
}  // namespace tdbd::reference::briggs_wedge_test

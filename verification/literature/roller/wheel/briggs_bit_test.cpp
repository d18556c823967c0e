#include "reference/literature/roller/wheel/briggs_bit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "battery/generators.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "reference/literature/roller/wheel/briggs_wedge.hpp"
#include "reference/literature/roller/wheel/briggs_wheel.hpp"

namespace tdbd::reference::briggs_bit_test {

const CoulombRock shale{24.82e6, 23.8 * degree};
const BriggsBit tricone{{60e-3, 12, 30.0 * degree, 10e-3}, 3, 70e-3};
/// Both ways meet on any columns: these are coarse.
const RollingOptions coarse{.column = 0.02e-3, .step = 0.16e-3};
constexpr double speed = 3.0 * pi;  // rad/s, 90 rpm

constexpr double one_percent = 0.01;  // as the worked numbers of a wheel are given
constexpr double of_columns = 1e-3;   // relative, of columns of 0.01 mm, steps of 0.08 mm and roots

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(BriggsBit, is_three_wheels) {
  const BriggsDrilling d = briggs_at_penetration(tricone, shale, 2e-3, speed);
  expect_near(d.weight, 3.0 * 1191.7, one_percent);
  expect_near(d.torque, 3.0 * 117.4 * 70e-3, one_percent);
  expect_near(d.cone_ratio, 70.0 / 59.03, 1e-3);
}

/// Wheels that turn freely and do not rise: all power goes through the torque.
TEST(BriggsBit, its_power_crushes_the_rock) {
  const BriggsDrilling d = briggs_at_penetration(tricone, shale, 2e-3, speed);
  const double volume_rate =
      2.0 * pi * tricone.track_radius * tricone.wheel.width * d.rate;  // m3/s
  expect_near(d.torque * speed, wedge_pressure(shale, tricone.wheel.half_angle) * volume_rate,
              0.01);
}

TEST(BriggsBit, penetration_from_weight_undoes_weight_from_penetration) {
  for (const double penetration : {0.5e-3, 2e-3, 4e-3}) {
    const BriggsDrilling d = briggs_at_penetration(tricone, shale, penetration, speed, coarse);
    const BriggsDrilling back = briggs_under_weight(tricone, shale, d.weight, speed, coarse);
    expect_near(back.penetration, penetration, 3.0 * of_columns);
    expect_near(back.weight, d.weight, 3.0 * of_columns);
  }
}

TEST(BriggsBit, cohesion_from_rate_undoes_rate_from_cohesion) {
  const BriggsDrilling d = briggs_under_weight(tricone, shale, 4e3, speed, coarse);
  const double c = briggs_cohesion(tricone, shale.friction_angle, 4e3, d.rate, speed, coarse);
  expect_near(c, shale.cohesion, of_columns);
}

TEST(BriggsBit, a_weaker_rock_drills_faster_and_turns_harder) {
  const CoulombRock weak{0.5 * shale.cohesion, shale.friction_angle};
  const BriggsDrilling hard = briggs_under_weight(tricone, shale, 4e3, speed, coarse);
  const BriggsDrilling soft = briggs_under_weight(tricone, weak, 4e3, speed, coarse);
  EXPECT_GT(soft.rate, 1.5 * hard.rate);
  EXPECT_GT(soft.torque, hard.torque);
}

/// This row rolls at 1.66647 turns a turn where nothing yields.
TEST(BriggsBit, of_a_row_rolls_on_the_row_s_track) {
  RollerCone cone;
  cone.journal_angle = 36.0 * degree;
  cone.rows = {{.along = 80e-3, .radius = 60e-3, .tooth_radius = 6e-3, .angles = {}}};
  cone.rows[0].angles.resize(25);
  const BriggsBit bit = briggs_bit({{cone, cone, cone}}, 0, 0, 0.7, 12e-3);
  EXPECT_EQ(bit.wheels, 3);
  EXPECT_EQ(bit.wheel.teeth, 25);
  EXPECT_NEAR(bit.track_radius / bit.wheel.radius, 1.66647, 5e-6);
  EXPECT_NEAR(briggs_at_penetration(bit, shale, 0.5e-3, speed).cone_ratio, 1.67, 0.01);
  EXPECT_THROW(briggs_bit({}, 0, 0, 0.7, 12e-3), InputError);
  EXPECT_THROW(briggs_bit({{cone}}, 0, 1, 0.7, 12e-3), InputError);
}

TEST(BriggsBit, names_itself_and_what_it_needs) {
  const auto message = [](double weight, double rotary_speed) -> std::string {
    try {
      briggs_under_weight(tricone, shale, weight, rotary_speed);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message(0.0, speed), "Briggs: found no weight, expected one above 0");
  EXPECT_EQ(message(1e3, 0.0), "Briggs: found no rotary speed, expected one above 0");
  EXPECT_EQ(message(1e6, speed).substr(0, 34), "Briggs: a penetration (m) at which");
}

}  // namespace tdbd::reference::briggs_bit_test

namespace tdbd::reference::briggs_wedge_test {

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

}  // namespace tdbd::reference::briggs_wedge_test

namespace tdbd::reference::briggs_wheel_test {

const Sprocket worked{60e-3, 12, 30.0 * degree, 10e-3};
const double pressure = wedge_pressure({24.82e6, 23.8 * degree}, worked.half_angle);
constexpr double one_percent = 0.01;  // as the worked numbers are given
constexpr double of_columns = 1e-3;   // relative, of columns of 0.01 mm and steps of 0.08 mm

Rolling rolled(const Sprocket& wheel, double penetration, double rolling_radius,
               const RollingOptions& options = {}) {
  Rolling r;
  roll(wheel, pressure, penetration, rolling_radius, options, r);
  return r;
}

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(BriggsWheel, the_worked_sprocket_has_the_worked_loads) {
  const double radius = free_rolling_radius(worked, 2e-3, {});
  EXPECT_NEAR(radius, 59.03e-3, 0.02e-3);
  const Rolling r = rolled(worked, 2e-3, radius);
  expect_near(r.load, 1191.7, one_percent);
  EXPECT_EQ(r.least_load, 0.0);
  expect_near(r.most_load, 3448.0, one_percent);
  expect_near(r.drag, 117.4, one_percent);
  expect_near(r.drag / r.load, 0.0985, one_percent);
}

TEST(BriggsWheel, the_work_of_four_pitches_is_the_worked_one) {
  const double radius = 59.03e-3, pitch = radius * 2.0 * pi / 12.0;
  const Rolling r = rolled(worked, 2e-3, radius, {.distance = 3.5 * pitch});
  EXPECT_NEAR(r.distance, 4.0 * pitch, 1e-12);
  expect_near(r.drag * r.distance, 14.51, 2.0 * one_percent);
  expect_near(pressure * worked.width * r.removed_area, 14.49, one_percent);
}

TEST(BriggsWheel, the_least_penetration_still_closes_the_work_to_a_percent) {
  const Rolling r = rolled(worked, 0.05e-3, 59.9e-3);
  const double crushed = pressure * worked.width * r.removed_area;
  expect_near(r.drag * r.distance - r.axle_torque * r.angle, crushed, one_percent);
}

/// Whether the wheel is free, driven or braked.
TEST(BriggsWheel, work_at_the_axle_is_pressure_times_the_volume_of_the_craters) {
  for (const double radius : {57e-3, 59.03e-3, 61e-3}) {
    const Rolling r = rolled(worked, 2e-3, radius);
    const double crushed = pressure * worked.width * r.removed_area;
    expect_near(r.drag * r.distance - r.axle_torque * r.angle, crushed, of_columns);
  }
}

TEST(BriggsWheel, finer_columns_and_steps_change_the_load_by_little) {
  const Rolling coarse = rolled(worked, 2e-3, 59.03e-3);
  const Rolling fine = rolled(worked, 2e-3, 59.03e-3, {.column = 0.005e-3, .step = 0.04e-3});
  expect_near(coarse.load, fine.load, 5.0 * of_columns);
  expect_near(coarse.drag, fine.drag, 5.0 * of_columns);
}

TEST(BriggsWheel, a_smooth_wheel_has_the_load_and_drag_of_its_arc) {
  const double R = 60e-3, delta = 2e-3, width = 10e-3;
  const Rolling r = rolled(smooth_wheel(R, 720, width), delta, R, {.distance = 0.03});
  expect_near(r.load, pressure * width * std::sqrt(2.0 * R * delta - delta * delta),
              5.0 * of_columns);
  expect_near(r.drag, pressure * width * delta, of_columns);
  expect_near(r.removed_height(), delta, of_columns);
}

/// Least squares of ln(drag/load) over ln(penetration), five penetrations.
TEST(BriggsWheel, drag_over_load_of_a_smooth_wheel_grows_as_the_root_of_the_penetration) {
  const Sprocket wheel = smooth_wheel(60e-3, 720, 10e-3);
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  constexpr std::array penetrations{0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3};
  for (const double delta : penetrations) {
    const Rolling r = rolled(wheel, delta, wheel.radius, {.distance = 0.02});
    const double x = std::log(delta), y = std::log(r.drag / r.load);
    expect_near(r.drag / r.load, smooth_wheel_drag(wheel.radius, delta), 2.0 * one_percent);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double n = penetrations.size();
  EXPECT_NEAR((n * sxy - sx * sy) / (n * sxx - sx * sx), 0.5, 0.02);
}

TEST(BriggsWheel, forces_grow_with_the_pressure_and_the_free_radius_does_not) {
  Rolling one, two;
  roll(worked, 1e8, 2e-3, 59e-3, {}, one);
  roll(worked, 2e8, 2e-3, 59e-3, {}, two);
  expect_near(two.load, 2.0 * one.load, 1e-13);
  EXPECT_EQ(two.removed_area, one.removed_area);
  EXPECT_EQ(std::accumulate(one.loads.begin(), one.loads.end(), 0.0) /
                static_cast<double>(one.loads.size()),
            one.load);
}

TEST(BriggsWheel, a_used_result_gives_the_same_again) {
  Rolling used;
  roll(worked, pressure, 3e-3, 59e-3, {.distance = 0.3}, used);
  roll(worked, pressure, 2e-3, 59e-3, {}, used);
  const Rolling fresh = rolled(worked, 2e-3, 59e-3);
  EXPECT_EQ(used.loads, fresh.loads);
  EXPECT_EQ(used.profile, fresh.profile);
  EXPECT_EQ(used.removed_area, fresh.removed_area);
}

TEST(BriggsWheel, names_its_model_and_what_it_needs) {
  const auto message = [](const Sprocket& wheel, double penetration) -> std::string {
    try {
      rolled(wheel, penetration, wheel.radius);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message({60e-3, 2, 0.5, 1e-2}, 1e-3),
            "Briggs: found a wheel of 2 teeth, expected at least 3");
  EXPECT_EQ(message(worked, 0.07),
            "Briggs: found a penetration of 0.070000 m, expected one between 0 and the wheel's "
            "radius");
  EXPECT_EQ(message(worked, 0.04e-3),
            "Briggs: found a penetration of 0.000040 m, expected at least 5 columns of the rock's "
            "profile");
  EXPECT_EQ(message({60e-3, 12, 1.5, 1e-2}, 1e-3),
            "Briggs: found teeth of half-angle 1.500000 rad, expected at most that of a polygon's "
            "corners, 1.308997 rad");
  EXPECT_EQ(message({60e-3, 12, 0.2, 1e-2}, 2e-3),
            "Briggs: found teeth of half-angle 0.200000 rad, expected more than the arc in the "
            "rock, 0.258922 rad: sharper teeth undercut");
}

}  // namespace tdbd::reference::briggs_wheel_test

#include "reference/literature/roller/wheel/briggs_wheel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "core/angles.hpp"
#include "core/error.hpp"
#include "reference/literature/roller/wheel/briggs_wedge.hpp"

namespace tdbd::reference::briggs_wheel_test {
namespace {

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

}  // namespace
}  // namespace tdbd::reference::briggs_wheel_test

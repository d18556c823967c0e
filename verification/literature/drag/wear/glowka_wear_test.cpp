#include "reference/literature/drag/wear/glowka_wear.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "battery/generators.hpp"
#include "core/angles.hpp"

namespace tdbd::reference::glowka_wear_test {
namespace {

/// Relative. The worked numbers are this project's own; no paper prints them.
constexpr double digits = 1e-6;
constexpr double ice = 273.15;  // K

const GlowkaFace face{8e-3, 20.0 * degree};

double between(double lo, double hi) { return lo + (hi - lo) * *battery::number(0.0, 1.0); }

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(GlowkaWear, flats_of_a_16_mm_cutter_have_the_worked_areas_and_volumes) {
  expect_near(flat_area(face, 0.5e-3), 5.461200e-6, digits);
  expect_near(flat_area(face, 1.0e-3), 15.297898e-6, digits);
  expect_near(flat_area(face, 2.0e-3), 42.412637e-6, digits);
  expect_near(worn_volume(face, 0.5e-3), 1.029170e-9, digits);
  expect_near(worn_volume(face, 1.0e-3), 5.782090e-9, digits);
  expect_near(worn_volume(face, 2.0e-3), 32.252250e-9, digits);
}

/// Gauss's rule of five points on each of many strips.
RC_GTEST_PROP(GlowkaWear, the_volume_is_the_integral_of_the_area, ()) {
  const GlowkaFace f{between(4e-3, 12e-3), between(0.05, 1.0)};
  const double y = between(0.001, 1.999) * f.radius;
  constexpr int strips = 2000;
  double sum = 0.0;  // Simpson's rule in u with height y u^2: smooth at 0, where A_seg is not
  for (int k = 0; k <= 2 * strips; ++k) {
    const double u = k / (2.0 * strips);
    const double weight = k == 0 || k == 2 * strips ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += weight * 2.0 * u * y * segment_area(f.radius, y * u * u) / (6.0 * strips);
  }
  const double expected = sum / std::tan(f.back_rake);
  RC_ASSERT(std::abs(worn_volume(f, y) - expected) < 1e-8 * expected);
}

TEST(GlowkaWear, a_cutter_worn_to_its_end_lost_its_wedge) {
  // All of a cylinder above an oblique plane through its rim: half of pi a^2 times its height.
  expect_near(worn_volume(face, 16e-3), pi * 8e-3 * 8e-3 * 16e-3 / std::tan(face.back_rake) / 2.0,
              1e-14);
  expect_near(flat_area(face, 16e-3), pi * 8e-3 * 8e-3 / std::sin(face.back_rake), 1e-14);
}

const FlatHeat worked{.friction = 0.6,
                      .rock_conductivity = 2.0,
                      .rock_diffusivity = 1e-6,
                      .cutter_resistance = 0.5e-4};

TEST(GlowkaWear, the_worked_flat_is_at_394_degrees) {
  EXPECT_NEAR(flat_temperature(worked, 800.0, 0.5, 12.9e-6, 4e-3) - ice, 394.15, 0.005);
}

TEST(GlowkaWear, a_flat_on_rock_that_takes_no_heat_keeps_all_of_it) {
  FlatHeat heat = worked;
  heat.rock_conductivity = 1e-12;
  const double flux = 0.6 * 800.0 * 0.5 / 12.9e-6;
  expect_near(flat_temperature(heat, 800.0, 0.5, 12.9e-6, 4e-3),
              heat.fluid_temperature + 0.5e-4 * flux, 1e-9);
}

TEST(GlowkaWear, a_cutter_that_takes_no_heat_is_as_hot_as_the_rock_below_it) {
  FlatHeat heat = worked;
  heat.cutter_resistance = 1e6;
  // The mean over a band of length L that moves fast: (4/(3 sqrt pi)) q sqrt(alpha L/v)/k, the mean of
  // 2 q sqrt(alpha t/pi)/k over the times 0 to L/v that its points have passed below it.
  const double flux = 0.6 * 800.0 * 0.5 / 12.9e-6, time = 4e-3 / 0.5;
  double mean = 0.0;
  constexpr int parts = 100000;
  for (int i = 0; i < parts; ++i)
    mean += 2.0 * flux * std::sqrt(1e-6 * time * (i + 0.5) / parts / pi) / 2.0 / parts;
  expect_near(flat_temperature(heat, 800.0, 0.5, 12.9e-6, 4e-3) - heat.fluid_temperature, mean,
              1e-6);
}

TEST(GlowkaWear, is_faster_only_above_the_threshold) {
  const WearLaw law{.coefficient = 2e-17, .threshold = 350.0 + ice, .growth = 40.0};
  EXPECT_EQ(wear_coefficient(law, 300.0 + ice), 2e-17);
  expect_near(wear_coefficient(law, 390.0 + ice), 2e-17 * std::exp(1.0), 1e-13);
}

RC_GTEST_PROP(GlowkaWear, its_speed_is_the_lost_volume_over_the_lost_height, ()) {
  const GlowkaFace f{between(4e-3, 12e-3), between(0.05, 1.0)};
  const WearLaw law{.coefficient = 2e-17, .threshold = 623.15, .growth = 50.0};
  const double y = between(0.05, 1.0) * f.radius, stress = between(1e6, 3e8), v = between(0.1, 3.0);
  const double force = stress * flat_area(f, y);
  const double volume_rate = wear_coefficient(law, 700.0) * force * v;
  const double step = 1e-5 * f.radius;
  const double volume_per_height =
      (worn_volume(f, y + step) - worn_volume(f, y - step)) / (2.0 * step);
  RC_ASSERT(std::abs(wear_speed(law, f, 700.0, stress, v) * volume_per_height / volume_rate - 1.0) <
            1e-7);
}

}  // namespace
}  // namespace tdbd::reference::glowka_wear_test

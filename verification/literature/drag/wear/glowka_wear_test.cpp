#include "reference/literature/drag/wear/glowka_wear.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/generators.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "literature/drag/wear/glowka_laws.hpp"
#include "reference/literature/drag/wear/glowka_metres.hpp"

namespace tdbd::reference::glowka_wear_test {

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

}  // namespace tdbd::reference::glowka_wear_test

namespace tdbd::reference::glowka_metres_test {

using namespace glowka_laws;

const GlowkaRun run{.advance = 2e-3, .rotary_speed = 4.0 * pi};
const WearLaw slow{.coefficient = 4e-16};

GlowkaBit bit_b() { return glowka_bit(cutters_of("bit-b"), 0.05e-3); }

GlowkaWear drill(const GlowkaLaw& law, const FlatHeat& heat, const GlowkaWearOptions& options) {
  return glowka_wear(bit_b(), law, heat, slow, run, options);
}

/// Under a stress that no depth changes and without heat, dy/ds = C0 stress 2 pi r/(d cos b).
TEST(GlowkaMetres, a_constant_stress_wears_as_archard_has_it) {
  GlowkaLaw law = in_granite;
  law.flat_stress = {100e6, 1e-3, 0.0};
  const GlowkaWear wear = drill(law, FlatHeat{}, {.distance = 3.0, .records = 3});
  const auto cutters = cutters_of("bit-b");
  ASSERT_EQ(wear.records.size(), 4U);
  for (const GlowkaWearRecord& record : wear.records)
    for (std::size_t i = 0; i < cutters.size(); ++i) {
      if (record.loads.cutters[i].area == 0.0) continue;
      const double expected = slow.coefficient * 100e6 * 2.0 * pi * cutters[i].tip_radius /
                              run.advance * record.distance / std::cos(cutters[i].back_rake);
      EXPECT_NEAR(record.worn[i], expected, 1e-12 * 1e-3) << cutters[i].id;  // of 1 mm
    }
}

double largest_change(const GlowkaWear& a, const GlowkaWear& b) {
  double change = 0.0;
  for (std::size_t i = 0; i < a.records.back().worn.size(); ++i)
    change = std::max(change, std::abs(a.records.back().worn[i] - b.records.back().worn[i]));
  return change;
}

GlowkaWear granite(double tolerance) {
  return drill(
      in_granite, granite_heat,
      {.distance = 20.0, .records = 4, .height_tolerance = tolerance, .share_tolerance = 0.0});
}

constexpr double step_error = 5e-6;  // m, of flats that lost up to 1 mm

/// The error of a step goes with its square, so a quarter of the tolerance halves the steps.
TEST(GlowkaMetres, halving_the_steps_changes_no_flat_by_5_micrometres) {
  const GlowkaWear usual = granite(1e-6), halved = granite(0.25e-6);
  EXPECT_GT(halved.steps, 1.5 * usual.steps);
  EXPECT_LT(largest_change(usual, halved), step_error);
}

/// A cutter that runs away to half its face is followed in shares of its height.
TEST(GlowkaMetres, the_share_of_the_height_that_steps_may_miss_moves_the_end_by_little) {
  const auto end = [](double share) {
    return drill(in_granite, granite_heat,
                 {.distance = 40.0, .records = 1, .share_tolerance = share});
  };
  const GlowkaWear strict = end(0.5e-3), usual = end(2e-3);
  ASSERT_TRUE(strict.worn_out.has_value());
  EXPECT_NEAR(usual.records.back().distance, strict.records.back().distance, 0.01);  // m
  EXPECT_LT(usual.steps, strict.steps);
}

double hottest(const GlowkaWearRecord& record) {
  double temperature = 0.0;
  for (const GlowkaCutterLoad& l : record.loads.cutters)
    temperature = std::max(temperature, l.temperature);
  return temperature;
}

double most_worn(const GlowkaWearRecord& record) {
  return *std::max_element(record.worn.begin(), record.worn.end());
}

/// Flats grow evenly while they are cool, and run away once friction heats them past the threshold.
TEST(GlowkaMetres, wear_runs_away_above_the_threshold) {
  const GlowkaWear wear = granite(1e-6);
  ASSERT_EQ(wear.records.size(), 5U);
  EXPECT_LT(hottest(wear.records[2]), slow.threshold);
  EXPECT_GT(hottest(wear.records[4]), slow.threshold + 50.0);
  const double even = most_worn(wear.records[1]);
  EXPECT_NEAR(most_worn(wear.records[2]), 2.0 * even, 1e-3 * even);
  EXPECT_GT(most_worn(wear.records[4]) - most_worn(wear.records[3]), 3.0 * even);
}

TEST(GlowkaMetres, the_weight_for_an_advance_rises_as_flats_grow) {
  const GlowkaWear wear = granite(1e-6);
  for (std::size_t k = 1; k < wear.records.size(); ++k)
    EXPECT_GT(wear.records[k].loads.weight, wear.records[k - 1].loads.weight);
}

TEST(GlowkaMetres, starts_from_the_wear_in_the_cutter_table_and_continues_as_one_run) {
  const GlowkaWearOptions half{.distance = 10.0, .records = 1};
  const GlowkaWear first = drill(in_granite, granite_heat, half);
  auto cutters = cutters_of("bit-b");
  for (std::size_t i = 0; i < cutters.size(); ++i)
    cutters[i].wear = first.records.back().worn[i] * std::cos(cutters[i].back_rake);
  const GlowkaWear second =
      glowka_wear(glowka_bit(cutters, 0.05e-3), in_granite, granite_heat, slow, run, half);
  const GlowkaWear whole = granite(1e-6);
  EXPECT_LT(largest_change(second, whole), step_error);
}

TEST(GlowkaMetres, ends_where_a_cutter_lost_half_its_face) {
  const GlowkaWear wear = glowka_wear(bit_b(), in_granite, granite_heat, {.coefficient = 1e-14},
                                      run, {.distance = 1000.0, .height_tolerance = 1e-4});
  ASSERT_TRUE(wear.worn_out.has_value());
  EXPECT_LT(wear.records.back().distance, 1000.0);
  EXPECT_GE(wear.records.back().worn[*wear.worn_out], 9.5e-3);
}

TEST(GlowkaMetres, names_itself_and_what_it_needs) {
  const auto message = [](const GlowkaLaw& law, const WearLaw& wear, double distance,
                          int most_steps) -> std::string {
    try {
      glowka_wear(bit_b(), law, granite_heat, wear, run,
                  {.distance = distance, .most_steps = most_steps});
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message(in_granite, slow, 0.0, 10),
            "Glowka: found no distance to drill, expected one above 0");
  EXPECT_EQ(message(sharp_in_berea, slow, 1.0, 10),
            "Glowka: found a law without stress under a wear flat, expected one above 0: wear "
            "needs it");
  EXPECT_EQ(message(in_granite, {}, 1.0, 10),
            "Glowka: found no wear coefficient, expected one above 0");
  EXPECT_EQ(message(in_granite, slow, 1000.0, 3).substr(0, 26), "Glowka: wear took 3 steps ");
}

}  // namespace tdbd::reference::glowka_metres_test

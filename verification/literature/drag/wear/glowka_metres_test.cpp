#include "reference/literature/drag/wear/glowka_metres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angles.hpp"
#include "core/error.hpp"
#include "literature/drag/wear/glowka_laws.hpp"

namespace tdbd::reference::glowka_metres_test {
namespace {

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

TEST(GlowkaMetres, starts_from_the_wear_in_the_cutter_table_and_goes_on_as_one_run) {
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

}  // namespace
}  // namespace tdbd::reference::glowka_metres_test

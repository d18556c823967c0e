#include "reference/compare/findings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tdbd::reference::findings_test {
namespace {

TEST(Findings, names_of_quantities_are_all_different) {
  std::set<std::string_view> names;
  for (const QuantityText& q : quantity_texts()) names.insert(q.name);
  EXPECT_EQ(names.size(), quantity_count);
  EXPECT_EQ(text_of(Quantity::hottest_flat).name, "hottest_flat");
  EXPECT_EQ(text_of(PartQuantity::teeth_in_contact).name, "teeth_in_contact");
}

TEST(Findings, levels_of_parts_are_read_from_their_names) {
  const auto level = [](const char* name) {
    return level_of({name, 0.0, PartQuantity::weight, 0.0});
  };
  EXPECT_EQ(level("cutter-12"), PartLevel::cutter);
  EXPECT_EQ(level("cone-1"), PartLevel::cone);
  EXPECT_EQ(level("cone-1/row-2"), PartLevel::row);
  EXPECT_EQ(level("cone-1/row-2/tooth-3"), PartLevel::tooth);
}

TEST(Findings, a_number_that_is_not_finite_is_a_blank_with_its_reason) {
  Findings f;
  say(f, Quantity::weight, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(saying(f, Quantity::weight).value);
  EXPECT_EQ(saying(f, Quantity::weight).reason, "its number is not finite");
}

TEST(Findings, a_reason_never_replaces_a_number_or_an_earlier_reason) {
  Findings f;
  say(f, Quantity::weight, 1.0);
  cannot_say(f, Quantity::torque, "first");
  cannot_say(f, {Quantity::weight, Quantity::torque, Quantity::imbalance}, "second");
  EXPECT_EQ(saying(f, Quantity::weight).value, 1.0);
  EXPECT_EQ(saying(f, Quantity::torque).reason, "first");
  EXPECT_EQ(saying(f, Quantity::imbalance).reason, "second");
}

/// A sine of amplitude a about 1 has the rms deviation a / sqrt 2; averaged over n of N steps a
/// period, sin(pi n/N) / (n sin(pi/N)) of it is left.
TEST(Findings, noise_of_a_sine_is_its_rms_and_averages_as_sines_do) {
  constexpr std::size_t period = 20, together = 5;
  std::vector<double> values;
  for (std::size_t i = 0; i < 50 * period; ++i)
    values.push_back(
        1.0 + 0.3 * std::sin(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.37) / period));
  const double rms = 0.3 / std::numbers::sqrt2;
  EXPECT_NEAR(noise_of(values, 1).mean, 1.0, 1e-13);
  EXPECT_NEAR(noise_of(values, 1).share, rms, 1e-13);
  const double x = std::numbers::pi / period;
  EXPECT_NEAR(noise_of(values, together).share,
              rms * std::sin(together * x) / (together * std::sin(x)), 1e-13);
}

TEST(Findings, noise_of_nothing_is_nothing) {
  EXPECT_EQ(noise_of({}, 1).share, 0.0);
  EXPECT_EQ(noise_of({1.0}, 2).share, 0.0);
}

TEST(Findings, the_work_of_a_turn_adds_what_the_weight_does) {
  Findings f;
  say_steady_loads(f, 2.0e4, 1.2e3, 2e-3);
  EXPECT_NEAR(*saying(f, Quantity::work_of_a_turn_torque).value,
              1.2e3 + 2.0e4 * 2e-3 / (2.0 * std::numbers::pi), 1e-12);
  EXPECT_FALSE(saying(f, Quantity::torque_noise).value);
}

TEST(Findings, steps_longer_than_5_ms_have_no_mean_over_5_ms) {
  Findings f;
  say_loads(f, {0.02, {1.0, 2.0}, {3.0, 4.0}}, 1e-3);
  EXPECT_EQ(saying(f, Quantity::torque_noise_5ms).reason, "its step is longer than 5 ms");
  EXPECT_EQ(*saying(f, Quantity::torque).value, 3.5);
}

}  // namespace
}  // namespace tdbd::reference::findings_test

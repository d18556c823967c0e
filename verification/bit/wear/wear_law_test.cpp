#include "bit/wear/wear_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "bit/generate.hpp"
#include "reference/literature/drag/wear/glowka_wear.hpp"

namespace tdbd::bit::wear_law_test {
namespace {

constexpr double ice = 273.15;  // K

/// Relative. Both programs round a few operations and one exponential of an argument up to 20.
constexpr double rounding = 1e-14;

/// Sliding wear of k = 1e-4 and H = 50 GPa, under 800 N at 0.5 m/s, by independent
/// calculation: 1e-4/50e9 * 800 * 0.5 = 8e-13 m3/s.
TEST(BitWearLaw, sliding_wear_has_the_rate_of_archard) {
  const WearLaw law = SlidingWear{.coefficient = 1e-4, .hardness = 50e9};
  EXPECT_NEAR(wear_rate(law, {800.0, 0.5, 900.0}), 8e-13, rounding * 8e-13);
  EXPECT_EQ(wear_rate(law, {0.0, 0.5, 900.0}), 0.0);
  EXPECT_EQ(wear_rate(law, {800.0, 0.0, 900.0}), 0.0);
  EXPECT_EQ(wear_rate(NoWear{}, {800.0, 0.5, 900.0}), 0.0);
}

RC_GTEST_PROP(BitWearLaw, thermal_wear_is_that_of_the_reference, ()) {
  const double k = number(1e-6, 1e-3), hardness = number(1e9, 1e11);
  const double threshold = number(500.0, 900.0), growth = number(20.0, 100.0);
  const double temperature = number(280.0, 1300.0);
  const reference::WearLaw expected{k / hardness, threshold, growth};
  const WearLaw law = ThermalWear{{k, hardness}, threshold, growth};
  const double c = reference::wear_coefficient(expected, temperature);
  RC_ASSERT(std::abs(wear_coefficient(law, temperature) - c) <= rounding * c);
}

RC_GTEST_PROP(BitWearLaw, the_temperature_of_a_flat_is_that_of_the_reference, ()) {
  const FlatHeating h{number(0.05, 1.0), number(0.5, 6.0), number(2e-7, 3e-6), number(1e-5, 3e-4),
                      number(280.0, 420.0)};
  const reference::FlatHeat expected{h.friction, h.rock_conductivity, h.rock_diffusivity,
                                     h.cutter_resistance, h.fluid_temperature};
  const double force = number(1.0, 5e3), speed = number(0.01, 3.0), area = number(1e-7, 5e-5),
               length = number(1e-5, 1e-2);
  const double t = reference::flat_temperature(expected, force, speed, area, length);
  RC_ASSERT(std::abs(flat_temperature(h, {force, speed, area, length}) - t) <= rounding * t);
}

/// The same worked number as for the reference, 394.15 degrees Celsius: this project's own.
TEST(BitWearLaw, the_worked_flat_is_at_394_degrees) {
  const FlatHeating worked{0.6, 2.0, 1e-6, 0.5e-4, 20.0 + ice};
  EXPECT_NEAR(flat_temperature(worked, {800.0, 0.5, 12.9e-6, 4e-3}) - ice, 394.15, 0.005);
}

TEST(BitWearLaw, a_flat_that_nothing_heats_is_as_warm_as_the_fluid) {
  const FlatHeating worked{0.6, 2.0, 1e-6, 0.5e-4, 310.0};
  EXPECT_EQ(flat_temperature(worked, {0.0, 0.5, 1e-6, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.0, 1e-6, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.5, 0.0, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.5, 1e-6, 0.0}), 310.0);
}

TEST(BitWearLaw, a_table_is_linear_between_its_rows_and_constant_beyond_them) {
  const WearLaw law = TableWear{{300.0, 600.0, 700.0}, {1e-17, 4e-17, 2e-16}};
  EXPECT_EQ(wear_coefficient(law, 250.0), 1e-17);
  EXPECT_EQ(wear_coefficient(law, 300.0), 1e-17);
  EXPECT_NEAR(wear_coefficient(law, 400.0), 2e-17, rounding * 2e-17);
  EXPECT_EQ(wear_coefficient(law, 600.0), 4e-17);
  EXPECT_NEAR(wear_coefficient(law, 650.0), 1.2e-16, rounding * 1.2e-16);
  EXPECT_EQ(wear_coefficient(law, 700.0), 2e-16);
  EXPECT_EQ(wear_coefficient(law, 900.0), 2e-16);
}

}  // namespace
}  // namespace tdbd::bit::wear_law_test

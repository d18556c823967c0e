#include <gtest/gtest.h>

#include <ostream>

#include "app/small_case.hpp"

namespace tdbd::app::bad_wear_test {

TEST(WearResult, of_a_right_table) {
  const SmallCaseWithForces c(
      "[wear]\nlaw = \"sliding\"\ncoefficient = 1e-6\nhardness = \"50 GPa\"\nacceleration = 10\n");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_EQ(c.run().exit_code, 0) << c.run().err;
}

struct BadWear {
  const char* name;
  const char* wear;
  const char* message;  ///< after the file's name
};
void PrintTo(const BadWear& m, std::ostream* out) { *out << m.name; }

class BadWearTables : public ::testing::TestWithParam<BadWear> {};

TEST_P(BadWearTables, are_rejected_with_exit_code_2_and_their_line) {
  const SmallCaseWithForces c(GetParam().wear);
  expect_refused(c, std::string("case.toml:") + GetParam().message);
}

const BadWear mistakes[] = {
    {"a_negative_coefficient",
     "[wear]\nlaw = \"sliding\"\ncoefficient = -1e-6\nhardness = \"50 GPa\"\n",
     "20: wear.coefficient: found -1e-06, expected a plain number, >= 0"},
    {"a_hardness_of_0", "[wear]\nlaw = \"sliding\"\ncoefficient = 1e-6\nhardness = 0\n",
     "21: wear.hardness: found 0, expected pressure in Pa, > 0"},
    {"a_thermal_law_without_a_temperature_limit",
     "[wear]\nlaw = \"thermal\"\ncoefficient = 1e-6\nhardness = \"50 GPa\"\n",
     "18: wear.threshold: found nothing, expected temperature in K, > 0 (the key is required)"},
    {"a_negative_rate",
     "[wear]\nlaw = \"table\"\ntemperatures = [300, 400]\nrates = [1e-17, -1e-17]\n",
     "21: wear.rates: found -1e-17, expected rates, >= 0"},
    {"temperatures_that_fall",
     "[wear]\nlaw = \"table\"\ntemperatures = [400, 300]\nrates = [1e-17, 1e-17]\n",
     "20: wear.temperatures: found 300 K after 400 K, expected rising temperatures"},
    {"an_acceleration_of_0",
     "[wear]\nlaw = \"sliding\"\ncoefficient = 1e-6\nhardness = \"50 GPa\"\nacceleration = 0\n",
     "22: wear.acceleration: found 0, expected a plain number, > 0"},
    {"a_growth_of_all_of_a_cutter",
     "[wear]\nlaw = \"sliding\"\ncoefficient = 1e-6\nhardness = \"50 GPa\"\nlargest_growth = 1\n",
     "22: wear.largest_growth: found 1, expected a plain number, in [1e-06, 0.1]"},
    {"an_unknown_law", "[wear]\nlaw = \"archard\"\ncoefficient = 1e-6\nhardness = \"50 GPa\"\n",
     "19: wear.law: found \"archard\", expected one of sliding, thermal, table, none"},
};

INSTANTIATE_TEST_SUITE_P(One, BadWearTables, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

}  // namespace tdbd::app::bad_wear_test

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/step/measure.hpp"

namespace tdbd::simulation::spread_test {

RunningVariance of(const std::vector<double>& numbers) {
  RunningVariance s;
  for (const double x : numbers) add(s, x);
  return s;
}

TEST(RunningVariance, has_count_mean_and_deviation) {
  const RunningVariance s = of({2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  EXPECT_EQ(s.count, 8);
  EXPECT_DOUBLE_EQ(s.mean, 5.0);
  EXPECT_DOUBLE_EQ(deviation(s), 2.0);
  EXPECT_DOUBLE_EQ(relative_deviation(s), 0.4);
}

TEST(RunningVariance, of_no_value_and_about_zero_is_none) {
  EXPECT_EQ(deviation({}), 0.0);
  EXPECT_EQ(relative_deviation({}), 0.0);
  const RunningVariance about_zero = of({-3.0, 3.0});
  EXPECT_EQ(about_zero.mean, 0.0);
  EXPECT_EQ(deviation(about_zero), 3.0);
  EXPECT_EQ(relative_deviation(about_zero), 0.0);
}

/// Small differences of large numbers keep their digits.
TEST(RunningVariance, loses_no_digits_to_a_large_mean) {
  EXPECT_NEAR(deviation(of({1e9 - 1.0, 1e9, 1e9 + 1.0})), std::sqrt(2.0 / 3.0), 1e-15);
}

}  // namespace tdbd::simulation::spread_test

#include "simulation/study/variable_convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tdbd::simulation::variable_convergence_test {

/// Levels of one variable that is off 7 by 3 h^2, each with a scale of its own.
std::vector<ConvergenceLevel> quadratic(int count) {
  std::vector<ConvergenceLevel> levels;
  for (int i = 0; i < count; ++i) {
    const double h = std::ldexp(0.1, -i);
    ConvergenceLevel& level = levels.emplace_back();
    level.sizes = {h};
    level.steps = 10L << i;
    level.end.variables.push_back({"x", "m", {7.0 + 3.0 * h * h}, 1.0, i == 1 ? 9.0 : 7.0, false});
  }
  return levels;
}

TEST(VariableConvergence, between_levels_has_the_order_the_scale_and_the_limit) {
  const auto found = observe(quadratic(5), {{}, 2.0});
  ASSERT_EQ(found.size(), 1U);
  const VariableConvergence& x = found[0];
  EXPECT_EQ(x.name, "x");
  EXPECT_EQ(x.scale, 9.0);  // the largest
  ASSERT_EQ(x.differences.size(), 4U);
  EXPECT_NEAR(x.differences[0], 3.0 * 0.01 * 0.75, 1e-14);
  EXPECT_NEAR(x.order.order, 2.0, 1e-12);
  ASSERT_EQ(x.extrapolated.size(), 1U);
  EXPECT_NEAR(x.extrapolated[0], 7.0, 1e-12);
}

TEST(VariableConvergence, against_a_reference_has_the_errors_of_every_level) {
  const auto levels = quadratic(4);
  EndState reference;
  reference.variables = levels[0].end.variables;
  reference.variables[0].values = {7.0};
  const VariableConvergence x = observe(levels, {reference, 2.0}).at(0);
  EXPECT_EQ(x.scale, 9.0);
  ASSERT_EQ(x.differences.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(x.differences[i], 3.0 * std::pow(levels[i].sizes[0], 2), 1e-14);
  EXPECT_NEAR(x.order.order, 2.0, 1e-12);
}

/// Attitudes are no vectors, and what grows has nothing to be compared with.
TEST(VariableConvergence, of_attitudes_and_of_what_grows_has_no_limit) {
  auto attitudes = quadratic(5), growing = quadratic(5);
  for (ConvergenceLevel& level : attitudes) level.end.variables[0].factor = 0.5;
  growing.back().end.variables[0].values.push_back(0.0);
  for (const auto& levels : {attitudes, growing}) {
    const VariableConvergence x = observe(levels, {{}, 2.0}).at(0);
    EXPECT_NEAR(x.order.order, 2.0, 1e-12);
    ASSERT_TRUE(x.uncertainty);
    EXPECT_EQ(x.uncertainty->basis, UncertaintyBasis::observed_order);
    EXPECT_TRUE(x.extrapolated.empty());
  }
}

/// A study that was interrupted after its first level, or before its end.
TEST(VariableConvergence, of_one_level_has_no_difference_and_no_limit) {
  const VariableConvergence x = observe(quadratic(1), {{}, 2.0}).at(0);
  EXPECT_TRUE(x.differences.empty());
  EXPECT_TRUE(x.extrapolated.empty());
  EXPECT_FALSE(x.uncertainty);
  EXPECT_TRUE(observe({}, {{}, 2.0}).empty());
}

}  // namespace tdbd::simulation::variable_convergence_test

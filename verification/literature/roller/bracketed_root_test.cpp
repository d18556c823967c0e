#include "reference/literature/roller/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tdbd::reference::bracketed_root_test {
namespace {

TEST(BracketedRoot, finds_roots_and_says_when_there_is_none) {
  EXPECT_NEAR(bracketed_root([](double x) { return x * x * x - 2.0; }, 0.0, 3.0, 1e-12).value(),
              std::cbrt(2.0), 1e-11);
  EXPECT_NEAR(
      bracketed_root([](double x) { return std::exp(-20.0 * x) - 0.5; }, 0.0, 5.0, 1e-13).value(),
      std::log(2.0) / 20.0, 1e-11);
  EXPECT_FALSE(bracketed_root([](double x) { return x * x + 1.0; }, 0.0, 1.0, 1e-9).has_value());
  EXPECT_EQ(bracketed_root([](double x) { return x - 1.0; }, 1.0, 2.0, 1e-9), 1.0);
}

/// Plain regula falsi keeps one end of a curved function's bracket, and creeps away from the other.
TEST(BracketedRoot, needs_few_values_where_the_function_is_curved) {
  for (const double sign : {1.0, -1.0}) {
    int values = 0;
    const auto f = [&](double x) {
      ++values;
      return sign * (std::exp(-20.0 * sign * x) - 1e-3);
    };
    const double low = sign > 0.0 ? 0.0 : -5.0;
    EXPECT_NEAR(bracketed_root(f, low, low + 5.0, 1e-9).value(), sign * std::log(1e3) / 20.0, 1e-9);
    EXPECT_LT(values, 30);
  }
}

}  // namespace
}  // namespace tdbd::reference::bracketed_root_test

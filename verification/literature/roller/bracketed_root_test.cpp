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

}  // namespace
}  // namespace tdbd::reference::bracketed_root_test

#include "reference/literature/roller/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference::bracketed_root_test {
namespace {

TEST(BracketedRoot, is_found_to_rounding_and_counted) {
  int asked = 0;
  const BracketedRoot root = bracketed_root(
      [&](double x) {
        ++asked;
        return std::cos(x) - x;
      },
      {.low = 0.0, .high = 1.0, .what = "Dottie"});
  EXPECT_NEAR(root.x, 0.7390851332151607, 2e-16);
  EXPECT_EQ(root.evaluations, asked);
  EXPECT_LE(asked, 14);
}

TEST(BracketedRoot, may_stand_at_an_end) {
  const auto f = [](double x) { return x; };
  EXPECT_EQ(bracketed_root(f, {.low = 0.0, .high = 1.0, .what = ""}).x, 0.0);
  EXPECT_EQ(bracketed_root(f, {.low = -1.0, .high = 0.0, .what = ""}).x, 0.0);
}

TEST(BracketedRoot, says_where_it_looked) {
  try {
    bracketed_root([](double x) { return 1.0 + x * x; },
                   {.low = -1.0, .high = 2.0, .what = "Nobody: the nothing (m)"});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "Nobody: the nothing (m): found no root, the balance is 2 at -1 and 5 at 2, "
                 "expected a bracket at whose ends it has different signs");
  }
}

}  // namespace
}  // namespace tdbd::reference::bracketed_root_test

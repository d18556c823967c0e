#include <gtest/gtest.h>

#include <cmath>

#include "calibration/fit/trust_region.hpp"
#include "forces/generate.hpp"

namespace tdbd::calibration::bounded_map_test {
namespace {

/// With two ends, with a lower one, with none.
Range any_range() {
  const double lo = forces::number(-2.0, 2.0);
  switch (forces::index(3)) {
    case 0:
      return Range::within(lo, lo + forces::number(0.1, 5.0));
    case 1:
      return {.lo = lo};
    default:
      return {};
  }
}

double any_inside(const Range& r) {
  const double share = forces::number(0.001, 0.999);
  if (std::isfinite(r.hi)) return r.lo + share * (r.hi - r.lo);
  return std::isfinite(r.lo) ? r.lo + 10.0 * share : 10.0 * (share - 0.5);
}

/// Relative to the value's distance from the nearest end; 1000 times their ratio is lost near it.
RC_GTEST_PROP(BoundedMap, is_the_inverse_of_its_inverse, ()) {
  const Range r = any_range();
  const double value = any_inside(r);
  constexpr double rounding = 3e-15;
  RC_ASSERT(std::abs(value_of(r, free_variable(r, value)) - value) <= 10.0 * rounding);
  const double u = forces::number(-6.0, 6.0);
  constexpr double near_an_end = 1e-12;
  RC_ASSERT(std::abs(free_variable(r, value_of(r, u)) - u) <= near_an_end);
}

RC_GTEST_PROP(BoundedMap, has_the_slope_of_its_values, ()) {
  const Range r = any_range();
  const double value = any_inside(r), u = free_variable(r, value);
  constexpr double h = 1e-5, second_order = 6.5e-10;
  const double slope = (value_of(r, u + h) - value_of(r, u - h)) / (2.0 * h);
  RC_ASSERT(std::abs(slope - slope_at(r, value)) <= second_order);
}

RC_GTEST_PROP(BoundedMap, stays_inside_for_any_variable, ()) {
  const Range r = any_range();
  const double value = value_of(r, forces::number(-700.0, 700.0));
  RC_ASSERT(r.contains(value));
}

TEST(BoundedMap, detects_a_value_at_an_end) {
  const Range two = Range::within(1.0, 3.0), one = Range::non_negative();
  EXPECT_TRUE(is_at_bound(two, 1.00019, 2.0));
  EXPECT_FALSE(is_at_bound(two, 1.00021, 2.0));
  EXPECT_TRUE(is_at_bound(two, 2.99981, 2.0));
  EXPECT_FALSE(is_at_bound(two, 2.99979, 2.0));
  EXPECT_TRUE(is_at_bound(one, 0.99e-4 * 5.0, 5.0));
  EXPECT_FALSE(is_at_bound(one, 1.01e-4 * 5.0, 5.0));
  EXPECT_FALSE(is_at_bound({}, 0.0, 5.0));
}

}  // namespace
}  // namespace tdbd::calibration::bounded_map_test

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/study/variable_convergence.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::simulation::uncertainty_test {

/// A study of one number with a known limit.
struct Study {
  std::vector<double> sizes, values, differences;
  double limit = 0.0;

  double range() const {
    const auto [lo, hi] = std::ranges::minmax(values);
    return hi - lo;
  }
  Uncertainty estimate(double nominal) const {
    const std::vector<double> first(sizes.begin(), sizes.end() - 1);
    return uncertainty_of(observed_order(first, differences, std::abs(values.back())), sizes,
                          differences, nominal, range());
  }
  double error() const { return std::abs(values.back() - limit); }
};

template <class Value>
Study study(int levels, double ratio, double limit, Value&& value) {
  Study s;
  s.limit = limit;
  for (int i = 0; i < levels; ++i) {
    s.sizes.push_back(std::pow(ratio, -i));
    s.values.push_back(limit + value(s.sizes.back()));
    if (i > 0) s.differences.push_back(std::abs(s.values[i] - s.values[i - 1]));
  }
  return s;
}

/// (9) is exact for a power of the size; 1.25 of it, (11).
RC_GTEST_PROP(Uncertainty, of_a_power_of_the_size_is_five_quarters_of_its_error, ()) {
  const double p = *battery::number(0.6, 4.0), r = *battery::number(1.3, 2.5);
  const double c = *battery::number(0.1, 10.0);
  const Study s = study(5, r, 3.0, [&](double h) { return c * std::pow(h, p); });
  const Uncertainty u = s.estimate(4.0);
  // rounding of values over their last difference, and what it does to the order and the error
  const double rounding = 1e-15 * s.values.back() / s.differences.back(), step = std::pow(r, p);
  const double of_order = rounding / std::log(r), of_error = rounding * (step + 1 / (step - 1));
  RC_ASSERT(u.basis == UncertaintyBasis::observed_order);
  RC_ASSERT(std::abs(u.order - p) < of_order);
  RC_ASSERT(std::abs(u.error / s.error() - 1.0) < of_error);
  RC_ASSERT(u.value == 1.25 * u.error);
}

/// Two terms of either sign, the second nearly as large as the first at the coarsest level. Where
/// they cancel there to a twentieth, differences of five levels may all be too small.
RC_GTEST_PROP(Uncertainty, contains_the_error_of_two_terms, ()) {
  const double r = *battery::number(1.4, 2.1), second = *battery::number(-0.9, 1.0);
  const int p = *battery::integer(1, 2), levels = *battery::integer(5, 7);
  const Study s = study(levels, r, -2.0,
                        [&](double h) { return std::pow(h, p) + second * std::pow(h, p + 1); });
  RC_ASSERT(s.estimate(2.0).value >= s.error());
}

/// An order above the method's may be luck: the error is that of the method's order.
TEST(Uncertainty, does_not_count_on_more_than_the_method_has) {
  const Study s = study(5, 2.0, 1.0, [](double h) { return h * h * h; });
  const Uncertainty u = s.estimate(2.0);
  EXPECT_EQ(u.order, 2.0);
  EXPECT_NEAR(u.error, s.differences.back() / 3.0, 1e-15);
}

TEST(Uncertainty, without_a_settled_order_is_three_times_the_estimate) {
  const Study s = study(5, 2.0, 1.0, [](double h) { return h + 0.2 * h * std::cos(9.0 * h); });
  const Uncertainty u = s.estimate(2.0);
  EXPECT_EQ(u.basis, UncertaintyBasis::slope);
  EXPECT_EQ(u.factor, 3.0);
  EXPECT_EQ(u.value, 3.0 * u.error);
  EXPECT_GT(u.value, s.error());
}

/// Two neighbours that agree by chance say nothing of the limit: the others still do.
TEST(Uncertainty, contains_the_error_where_the_finest_difference_is_small_by_chance) {
  Study s = study(6, 2.0, 1.0, [](double h) { return h; });
  s.values[5] = s.values[4] + 1e-4 * s.sizes[5];
  s.differences[4] = std::abs(s.values[5] - s.values[4]);
  const Uncertainty u = s.estimate(2.0);
  EXPECT_EQ(u.basis, UncertaintyBasis::slope);
  EXPECT_GT(u.value, s.error());
}

TEST(Uncertainty, without_convergence_is_three_times_the_range) {
  const Study s = study(5, 2.0, 1.0, [](double h) { return std::cos(40.0 * h); });
  const Uncertainty u = s.estimate(2.0);
  EXPECT_EQ(u.basis, UncertaintyBasis::range);
  EXPECT_EQ(u.value, 3.0 * s.range());
}

TEST(Uncertainty, of_what_is_exact_is_none) {
  const Study s = study(5, 2.0, 1.0, [](double) { return 0.0; });
  EXPECT_EQ(s.estimate(2.0).basis, UncertaintyBasis::exact);
  EXPECT_EQ(s.estimate(2.0).value, 0.0);
}

/// The finest difference is rounding: what is left of the last one above stands for all below.
TEST(Uncertainty, rests_on_differences_above_rounding) {
  Study s = study(6, 2.0, 1.0, [](double h) { return h * h; });
  s.differences.back() = 1e-17;
  const Uncertainty u = s.estimate(2.0);
  EXPECT_NEAR(u.error, s.differences[3] / 3.0, 1e-15);
}

TEST(Uncertainty, of_two_levels_is_their_range) {
  const Study s = study(2, 2.0, 1.0, [](double h) { return h; });
  EXPECT_EQ(s.estimate(0.0).basis, UncertaintyBasis::range);
}

}  // namespace tdbd::simulation::uncertainty_test

#include "core/observed_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <span>

namespace tdbd::observed_order_test {

/// Steps 0.1, 0.05, ... and an error for each.
struct Study {
  std::vector<double> steps, errors;
};

Study study(int levels, const std::function<double(double)>& error) {
  Study s;
  for (int i = 0; i < levels; ++i) {
    s.steps.push_back(0.1 / std::pow(2.0, i));
    s.errors.push_back(error(s.steps.back()));
  }
  return s;
}

ObservedOrder observe(const Study& s, double scale = 1.0) {
  return observed_order(s.steps, s.errors, scale);
}

TEST(ObservedOrder, a_power_has_its_own_order) {
  for (const double p : {1.0, 2.0, 4.0}) {
    const ObservedOrder o = observe(study(5, [&](double h) { return 3.0 * std::pow(h, p); }));
    EXPECT_EQ(o.verdict, OrderVerdict::order);
    EXPECT_NEAR(o.order, p, 1e-12);
    EXPECT_NEAR(o.order_of_all, p, 1e-12);
    EXPECT_EQ(o.used, 5);
    EXPECT_EQ(o.first, 0);
    for (const double local : o.local_orders) EXPECT_NEAR(local, p, 1e-12);
  }
}

TEST(ObservedOrder, coarse_steps_before_the_asymptotic_range_are_left_out) {
  const ObservedOrder o =
      observe(study(8, [](double h) { return h * h / (1.0 + 2000.0 * h * h); }));
  EXPECT_EQ(o.verdict, OrderVerdict::order);
  EXPECT_GT(o.first, 1);
  EXPECT_NEAR(o.order, 2.0, 0.05);
  EXPECT_LT(o.order_of_all, 1.8);
}

TEST(ObservedOrder, rounding_at_fine_steps_is_left_out) {
  const ObservedOrder o = observe(study(12, [](double h) { return std::pow(h, 4) + 1e-13; }));
  EXPECT_EQ(o.verdict, OrderVerdict::order);
  EXPECT_NEAR(o.order, 4.0, 6e-4);
  EXPECT_EQ(o.first + o.used, o.above_floor);
  EXPECT_LT(o.above_floor, 12);
  EXPECT_TRUE(std::isnan(o.local_orders.back()));
}

TEST(ObservedOrder, rounding_alone_is_exact_and_no_order) {
  EXPECT_EQ(observe(study(6, [](double) { return 0.0; })).verdict, OrderVerdict::exact);
  const ObservedOrder o = observe(study(6, [](double h) { return 1e-13 * h; }));
  EXPECT_EQ(o.verdict, OrderVerdict::exact);
  EXPECT_EQ(o.order, 0.0);
  EXPECT_EQ(in_words(o, "errors"), "exact: all errors are rounding");
}

TEST(ObservedOrder, the_scale_defines_rounding) {
  const Study s = study(5, [](double h) { return h * h; });
  EXPECT_EQ(observe(s, 1.0).verdict, OrderVerdict::order);
  EXPECT_EQ(observe(s, 1e12).verdict, OrderVerdict::exact);
  EXPECT_EQ(observe(s, 1e8).above_floor, 2);
}

/// A long run has more rounding: its small errors no longer count as convergence.
TEST(ObservedOrder, the_floor_rises_with_the_number_of_time_steps) {
  Study s = study(8, [](double h) { return 1e-6 * h * h; });
  for (std::size_t i = 3; i < 8; ++i) s.errors[i] = (i % 2 == 0 ? 2e-10 : 3e-10);
  const std::vector<long> counts(8, 1'000'000);
  EXPECT_EQ(observe(s).verdict, OrderVerdict::not_settled);
  const ObservedOrder o = observed_order(s.steps, s.errors, 1.0, counts);
  EXPECT_EQ(o.above_floor, 2);
  EXPECT_EQ(observed_order(s.steps, std::vector<double>(8, 1e-10), 1.0, counts).verdict,
            OrderVerdict::exact);
}

/// Errors of these local orders between steps that are halved.
Study of_local_orders(const std::vector<double>& orders) {
  Study s{{1.0}, {1e-3}};
  for (const double p : orders) {
    s.steps.push_back(0.5 * s.steps.back());
    s.errors.push_back(std::pow(0.5, p) * s.errors.back());
  }
  return s;
}

/// Within a twentieth of the finest local order, whatever that is.
TEST(ObservedOrder, has_settled_to_a_part_of_itself) {
  EXPECT_EQ(observe(of_local_orders({3.85, 4.0, 4.0})).used, 4);
  EXPECT_EQ(observe(of_local_orders({3.75, 4.0, 4.0})).used, 3);
  EXPECT_EQ(observe(of_local_orders({4.25, 4.0, 4.0})).used, 3);
  EXPECT_EQ(observe(of_local_orders({0.48, 0.5, 0.5})).used, 4);
  EXPECT_EQ(observe(of_local_orders({0.47, 0.5, 0.5})).used, 3);
  EXPECT_EQ(observe(of_local_orders({-0.97, -1.0, -1.0})).used, 4) << "diverges, steadily";
}

/// What lies at the floor is not above it.
TEST(ObservedOrder, counts_errors_at_the_floor_as_rounding) {
  const double floor = 3.0 * order_floor;
  Study s = study(3, [&](double) { return order_exact * floor; });
  EXPECT_EQ(observe(s, 3.0).verdict, OrderVerdict::exact);
  s.errors[1] = 1.01 * order_exact * floor;
  EXPECT_EQ(observe(s, 3.0).verdict, OrderVerdict::too_few);
  s.errors = {4.0 * floor, 2.0 * floor, floor};
  EXPECT_EQ(observe(s, 3.0).above_floor, 2);
  EXPECT_TRUE(std::isnan(observe(s, 3.0).local_orders[1]));
  s.errors = {floor, 4.0 * floor, 2.0 * floor};
  EXPECT_EQ(observe(s, 3.0).above_floor, 2);
  EXPECT_TRUE(std::isnan(observe(s, 3.0).local_orders[0]));
}

/// As many errors as an order needs, all of them good.
TEST(ObservedOrder, the_fewest_errors_that_make_an_order_do) {
  std::vector<double> steps, errors;
  for (int k = 0; k < order_least_errors; ++k) {
    steps.push_back(std::pow(0.5, k));
    errors.push_back(3.0 * steps.back() * steps.back());
  }
  const ObservedOrder o = observed_order(steps, errors, 1.0);
  EXPECT_EQ(o.verdict, OrderVerdict::order);
  EXPECT_EQ(o.used, order_least_errors);
  EXPECT_NEAR(o.order, 2.0, 1e-14);
}

TEST(ObservedOrder, two_errors_give_none) {
  const ObservedOrder o = observe(study(2, [](double h) { return h * h; }));
  EXPECT_EQ(o.verdict, OrderVerdict::too_few);
  EXPECT_EQ(o.order, 0.0);
  EXPECT_NEAR(o.order_of_all, 2.0, 1e-12);
  EXPECT_EQ(in_words(o, "differences"),
            "no order: 2 of 2 differences above rounding, at least 3 are needed");
  EXPECT_EQ(observe(study(0, [](double) { return 1.0; })).verdict, OrderVerdict::too_few);
}

/// An error below the floor in between (a change of sign) breaks the range.
TEST(ObservedOrder, a_gap_ends_the_range) {
  Study s = study(7, [](double h) { return h * h; });
  s.errors[2] = 0.0;
  const ObservedOrder o = observe(s);
  EXPECT_EQ(o.verdict, OrderVerdict::order);
  EXPECT_EQ(o.first, 3);
  EXPECT_EQ(o.used, 4);
}

TEST(ObservedOrder, errors_that_wander_have_not_settled) {
  Study s = study(6, [](double h) { return h * h; });
  for (std::size_t i = 0; i < s.errors.size(); i += 2) s.errors[i] *= 1.5;
  const ObservedOrder o = observe(s);
  EXPECT_EQ(o.verdict, OrderVerdict::not_settled);
  EXPECT_EQ(o.order, 0.0);
  EXPECT_EQ(in_words(o, "errors").rfind("no order: not settled", 0), 0u) << in_words(o, "errors");
}

TEST(ObservedOrder, text_states_how_many_levels_were_used) {
  const ObservedOrder o = observe(study(4, [](double h) { return h * h; }));
  EXPECT_EQ(in_words(o, "errors"), "2.000 (4 of 4 errors)");
}

/// Any power, factor and size, with an error of the next order.
RC_GTEST_PROP(ObservedOrder, is_found_in_the_asymptotic_range, ()) {
  const double p = static_cast<double>(*rc::gen::inRange(1, 5));
  const double c = std::pow(10.0, *rc::gen::inRange(-3, 4));
  const double next = 0.01 * *rc::gen::inRange(-100, 101);
  Study s = study(6, [&](double h) { return c * std::pow(h, p) * (1.0 + next * h); });
  const ObservedOrder o = observed_order(s.steps, s.errors, c);
  RC_ASSERT(o.verdict == OrderVerdict::order);
  RC_ASSERT(std::abs(o.order - p) < 0.07);
}

/// The slope does not depend on the units of step and error.
RC_GTEST_PROP(LeastSquaresOrder, does_not_depend_on_units, ()) {
  const auto errors = *rc::gen::container<std::vector<int>>(6, rc::gen::inRange(1, 1000));
  Study s = study(6, [](double) { return 1.0; });
  for (std::size_t i = 0; i < 6; ++i) s.errors[i] = static_cast<double>(errors[i]);
  const double order = least_squares_order(s.steps, s.errors);
  for (double& h : s.steps) h *= 1000.0;
  for (double& e : s.errors) e *= 1e-6;
  RC_ASSERT(std::abs(least_squares_order(s.steps, s.errors) - order) < 1e-12);
}

/// For logarithms 0, 1, 2 of the steps and 0, 0, 3 of the errors the slope is 3/2, computed
/// manually. Each point counts.
TEST(ObservedOrder, is_the_slope_of_least_squares) {
  const double e = std::exp(1.0);
  const std::vector<double> steps{1.0, e, e * e}, errors{1.0, 1.0, e * e * e};
  EXPECT_NEAR(least_squares_order(steps, errors), 1.5, 1e-14);
  EXPECT_NEAR(least_squares_order(steps, std::vector{1.0, e, e * e}), 1.0, 1e-14);
  EXPECT_NEAR(least_squares_order(steps, std::vector{e * e * e, 1.0, 1.0}), -1.5, 1e-14);
  // the points of a longer study outside the given part have no influence
  const std::vector<double> wider{0.0, 1.0, e, e * e, 0.0};
  const std::span<const double> part = std::span(wider).subspan(1, 3);
  EXPECT_NEAR(least_squares_order(part, part), 1.0, 1e-14);
}

}  // namespace tdbd::observed_order_test

#include "dynamics/integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace tdbd::dynamics::integrator_test {

constexpr double rounding = 1e-14;

double power_sum(std::span<const double> fractions, int power) {
  double sum = 0.0;
  for (const double f : fractions) sum += std::pow(f, power);
  return sum;
}

TEST(Composition, fractions_are_symmetric_and_sum_to_one) {
  for (const int order : composition_orders) {
    const std::span<const double> f = composition(order);
    EXPECT_NEAR(power_sum(f, 1), 1.0, rounding) << order;
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_EQ(f[i], f[f.size() - 1 - i]);
  }
}

/// A symmetric step has errors of odd powers: the simplest order conditions require their sums to
/// vanish. The others are seen in the observed orders.
TEST(Composition, odd_power_sums_vanish_up_to_the_order) {
  for (const int order : composition_orders)
    for (int power = 3; power < order; power += 2)
      EXPECT_NEAR(power_sum(composition(order), power), 0.0, rounding) << order << " " << power;
}

TEST(Composition, has_the_published_numbers_of_stages) {
  EXPECT_EQ(composition(2).size(), 1u);
  EXPECT_EQ(composition(4).size(), 5u);
  EXPECT_EQ(composition(6).size(), 9u);
  EXPECT_EQ(composition(8).size(), 17u);
}

TEST(Composition, refuses_other_orders) {
  for (const int order : {0, 1, 3, 5, 10}) EXPECT_THROW(composition(order), RunError) << order;
}

}  // namespace tdbd::dynamics::integrator_test

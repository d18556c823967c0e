#include "reference/literature/roller/craters/cone_recursion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tdbd::reference::cone_recursion_test {
namespace {

/// Sums of a few hundred increments; scale: the result.
constexpr double of_sums = 1e-12;

/// An observed order differs from the scheme's by this at most; scale: 1.
constexpr double of_orders = 0.06;

ConeProblem constant(double torque, double speed) {
  return {0.005, speed, 0.1, [torque](double, double) { return torque; }};
}

/// A cone that rocks between teeth, with drag that grows with the square of its speed.
ConeProblem rocking() {
  return {0.005, -12.9, 0.2, [](double angle, double speed) {
            return 0.8 * std::sin(3.0 * angle) - 2e-4 * speed * std::abs(speed);
          }};
}

/// Ic = 0.005 kg m2, T = 2 N m, 100 steps of 1 ms from rest.
TEST(ConeRecursion, gives_the_worked_table_of_its_readings) {
  const auto rows = recursion_table(constant(2.0, 0.0), 100);
  ASSERT_EQ(rows.size(), 4U);
  const double expected[] = {1.0e-6, 0.0400, 2.0200, 2.0000};
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(rows[i].result, expected[i], of_sums * expected[i]) << i;
  EXPECT_NEAR(rows[2].error, 0.02, of_sums);
  EXPECT_EQ(rows[3].order.verdict, OrderVerdict::exact);
  // What is no integrator does not come nearer with the step.
  EXPECT_NEAR(rows[0].error, 2.0, 1e-5);
  EXPECT_NEAR(rows[1].error, 1.96, of_sums);
}

/// Without torque a cone coasts; only the increments know that.
TEST(ConeRecursion, coasts_only_when_it_adds_increments) {
  const auto rows = recursion_table(constant(0.0, -12.9), 100);
  EXPECT_EQ(rows[0].result, 0.0);
  EXPECT_EQ(rows[1].result, 0.0);
  EXPECT_NEAR(rows[2].result, -1.29, of_sums);
  EXPECT_NEAR(rows[3].result, -1.29, of_sums);
}

/// The result of reading (ii) is (T/Ic) t dt: it halves with the step.
TEST(ConeRecursion, without_inertia_the_angle_tends_to_nothing_with_the_step) {
  const ConeProblem p = constant(2.0, 0.0);
  const double coarse = recursion_result(p, ConeReading::divided, ConeStart::simple, 100);
  const double fine = recursion_result(p, ConeReading::divided, ConeStart::simple, 200);
  EXPECT_NEAR(fine, 0.5 * coarse, of_sums);
}

TEST(ConeRecursion, is_of_second_order_from_half_a_step_back_and_of_first_otherwise) {
  const auto rows = recursion_table(rocking(), 200);
  ASSERT_EQ(rows[2].order.verdict, OrderVerdict::order);
  ASSERT_EQ(rows[3].order.verdict, OrderVerdict::order);
  EXPECT_NEAR(rows[2].order.order, 1.0, of_orders);
  EXPECT_NEAR(rows[3].order.order, 2.0, of_orders);
  EXPECT_LT(rows[3].error, 0.5 * rows[2].error);
  for (int i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(rows[static_cast<std::size_t>(i)].order.order_of_all), 2e-6) << i;
}

/// A tooth held by rock of stiffness k at radius rho is a spring on the cone: the torque of a step's
/// beginning is stable up to dt2 k rho2/Ic = 4.
TEST(ConeRecursion, runs_away_beyond_its_limit_of_stiffness) {
  constexpr double k = 1e7, rho = 0.06, inertia = 0.005;
  const double limit = std::sqrt(4.0 * inertia / (k * rho * rho));
  EXPECT_NEAR(limit, 0.745e-3, 1e-6);
  const auto after = [&](double step) {
    ConeTurn cone = started_cone(1e-3, 0.0, 0.0, inertia, step, ConeStart::half_step);
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
      advance_cone(cone, ConeReading::increments, -k * rho * rho * cone.angle, inertia, step);
      largest = std::max(largest, std::abs(cone.angle));
    }
    return largest;
  };
  EXPECT_LT(after(0.99 * limit), 20e-3);
  EXPECT_GT(after(1.01 * limit), 1e10);
}

}  // namespace
}  // namespace tdbd::reference::cone_recursion_test

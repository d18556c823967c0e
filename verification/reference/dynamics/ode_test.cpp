#include "reference/dynamics/ode.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference::ode_test {

/// x'' = -x, as (x, x').
const RightHandSide oscillator = [](double, std::span<const double> y, std::span<double> dydt) {
  dydt[0] = y[1];
  dydt[1] = -y[0];
};

double oscillator_error(const std::vector<double>& y, double t) {
  return std::hypot(y[0] - std::cos(t), y[1] + std::sin(t));
}

/// Five thousand steps of equal length: the clock must not lose their rounding, 1e-12 s.
TEST(Ode, rounding_tolerance_reaches_rounding_and_keeps_the_time) {
  std::vector<double> y{1.0, 0.0};
  const long evaluations = integrate(oscillator, OdeMethod::rk8pd, {}, 0.0, 500.0, y);
  EXPECT_LE(oscillator_error(y, 500.0), 2e-13);  // 500 rad at 1e-16, with some room
  EXPECT_GT(evaluations, 20000);
}

TEST(Ode, counts_every_evaluation) {
  long called = 0;
  const RightHandSide counting = [&](double t, std::span<const double> y, std::span<double> dydt) {
    ++called;
    oscillator(t, y, dydt);
  };
  for (const OdeMethod method : {OdeMethod::rk8pd, OdeMethod::rkf45}) {
    called = 0;
    std::vector<double> y{1.0, 0.0};
    EXPECT_EQ(integrate(counting, method, {1e-8, 1e-8}, 0.0, 10.0, y), called);
  }
  called = 0;
  std::vector<double> y{1.0, 0.0};
  EXPECT_EQ(integrate_rk4(counting, 50, 0.0, 10.0, y), 200);
  EXPECT_EQ(called, 200);
}

TEST(Ode, a_loose_tolerance_costs_less_and_errs_more) {
  std::vector<double> loose{1.0, 0.0}, tight{1.0, 0.0};
  const long few = integrate(oscillator, OdeMethod::rkf45, {1e-4, 1e-4}, 0.0, 10.0, loose);
  const long many = integrate(oscillator, OdeMethod::rkf45, {1e-10, 1e-10}, 0.0, 10.0, tight);
  EXPECT_LT(5 * few, many);
  EXPECT_GT(oscillator_error(loose, 10.0), 1000.0 * oscillator_error(tight, 10.0));
}

TEST(Ode, rk4_is_of_order_4) {
  std::vector<double> errors;
  for (const int steps : {100, 200}) {
    std::vector<double> y{1.0, 0.0};
    integrate_rk4(oscillator, steps, 0.0, 10.0, y);
    errors.push_back(oscillator_error(y, 10.0));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, 3.2e-4);
}

/// y' = 3 t^2 from t = 1: every method must see the absolute time.
TEST(Ode, equations_see_the_time) {
  const RightHandSide cube = [](double t, std::span<const double>, std::span<double> dydt) {
    dydt[0] = 3.0 * t * t;
  };
  for (const OdeMethod method : {OdeMethod::rk8pd, OdeMethod::rkf45}) {
    std::vector<double> y{1.0};
    integrate(cube, method, {1e-12, 1e-12}, 1.0, 2.0, y);
    EXPECT_NEAR(y[0], 8.0, 1e-12);
  }
  std::vector<double> y{1.0};
  integrate_rk4(cube, 10, 1.0, 2.0, y);
  EXPECT_NEAR(y[0], 8.0, 1e-13);
}

/// y' = y^2, y(0) = 1 ends at t = 1.
TEST(Ode, a_singularity_is_an_error) {
  const RightHandSide explosion = [](double, std::span<const double> y, std::span<double> dydt) {
    dydt[0] = y[0] * y[0];
  };
  std::vector<double> y{1.0};
  EXPECT_THROW(integrate(explosion, OdeMethod::rk8pd, {}, 0.0, 2.0, y), RunError);
}

}  // namespace tdbd::reference::ode_test

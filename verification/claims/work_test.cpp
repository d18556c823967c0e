#include <fmt/format.h>
#include <gtest/gtest.h>

#include "battery/evidence.hpp"
#include "claims/carry.hpp"
#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::claims::work_test {

using battery::Verdict;

constexpr double t_end = 10.0;  // s

/// Least torque evaluations with which the composition reaches the error on the slow top and keeps
/// below it for the next few numbers of steps: not by a lucky crossing. 0: never.
long evaluations(const battery::GoldenCase& c, int order, double error) {
  constexpr long kept = 5, fewest = 10, most = 400;
  const dynamics::Integrator integrator{dynamics::Drift::split, 1, order};
  long least = 0;
  for (long steps = fewest, good = 0; steps < most && good < kept; ++steps) {
    const auto end = carry_to(c.gyrostat, c.loads, integrator, c.initial, t_end, steps);
    const double off = attitude_error(end.state.q_WB.toRotationMatrix(), golden_end(c));
    good = off <= error ? good + 1 : 0;
    if (good == 1) least = end.evaluations;
    if (good == 0) least = 0;
  }
  return least;
}

/// Least evaluations of GSL's rk8pd over tolerances a tenth of a decade apart.
long rk8pd_evaluations(const battery::GoldenCase& c, double error) {
  constexpr double ratio = 0.8;
  const reference::GyrostatState start = reference::matrix_state(c.initial);
  for (double tolerance = 1e-2; tolerance > 1e-15; tolerance *= ratio) {
    const auto run = reference::runge_kutta(c.gyrostat, c.loads, start, t_end,
                                            reference::OdeMethod::rk8pd, {tolerance, tolerance});
    if (attitude_error(run.state.R_WB, golden_end(c)) <= error) return run.evaluations;
  }
  return 0;
}

void check(int order, double error, long limit) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  const long own = evaluations(c, order, error), rival = rk8pd_evaluations(c, error);
  const bool fewer = own > 0 && own <= limit && own < rival;
  EXPECT_TRUE(fewer) << own << " evaluations, rk8pd " << rival;
  battery::record(
      {"ours/fewer-evaluations",
       fmt::format("order {} of the split drift: torque evaluations to an attitude error of {} "
                   "rad on the slow top at {} s",
                   order, error, t_end),
       static_cast<double>(own), "1", fmt::format("<= {}; GSL's rk8pd takes {}", limit, rival),
       fewer ? Verdict::holds : Verdict::refuted});
}

TEST(Work, the_fourth_order_reaches_a_millionth_in_500_evaluations) { check(4, 1e-6, 500); }

TEST(Work, the_eighth_order_reaches_a_billionth_in_1100_evaluations) { check(8, 1e-9, 1100); }

}  // namespace tdbd::claims::work_test

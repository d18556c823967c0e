#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "calibration/fit/fit.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "calibration/twin_readings.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/types.hpp"

namespace tdbd::calibration::solve_test {
namespace {

/// Of each coefficient, relative; seen 4.3e-14.
constexpr double recovery = 1.3e-13;

TEST(Recovery, of_seven_coefficients_from_twenty_starts) {
  CalibrationCase c = made_up_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law());
  const Problem p = fitted_problem(c, cuts);
  const Eigen::VectorXd truth = truth_of(p, hidden_law());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Solution s = solve(p, data_of(p), drawn_start(p, seed));
    EXPECT_TRUE(s.converged) << seed << ": " << s.reason;
    EXPECT_LT(relative_difference(s.values, truth), recovery) << seed;
  }
}

/// Unknowns just inside an end of their range: on the way they are driven out and held, and have to be
/// freed again.
TEST(Recovery, of_coefficients_near_the_ends_of_their_ranges) {
  CalibrationCase c = made_up_case();
  const CutStore cuts = made_up_cuts(c);
  forces::HansonHansen law = hidden_law();
  for (const double inside : {1e-2, 3e-3, 1e-3, 3e-4}) {
    law.A2 = law.A4 = inside;
    read_loads(c, cuts, law);
    const Problem p = fitted_problem(c, cuts);
    const Eigen::VectorXd truth = truth_of(p, law);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Solution s = solve(p, data_of(p), drawn_start(p, seed));
      EXPECT_TRUE(s.converged) << inside << ", " << seed << ": " << s.reason;
      EXPECT_LT((s.values - truth).norm(), 1e-9) << inside << ", " << seed;
    }
  }
}

/// Within the middle half of a range, wherever it lies; within a factor of two of the case's where it has one end.
TEST(DrawnStart, is_well_inside_each_range) {
  Problem p;
  p.unknowns.resize(3);
  p.unknowns[0].range = Range::within(10.0, 12.0);
  p.unknowns[1].range = Range::within(-3.0, 1.0);
  p.unknowns[2].range = Range::non_negative();
  p.unknowns[2].start = 4.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Eigen::VectorXd start = drawn_start(p, seed);
    EXPECT_LE(std::abs(start[0] - 11.0), 0.5);
    EXPECT_LE(std::abs(start[1] + 1.0), 1.0);
    EXPECT_LE(std::abs(std::log2(start[2] / 4.0)), 1.0);
  }
}

/// The case's own start is no number, every drawn one has a sum of squares beyond all numbers: two reasons.
TEST(SolveFromStarts, reports_why_the_start_of_the_case_failed) {
  Problem p;
  p.unknowns.resize(1);
  p.unknowns[0].range = Range::within(0.0, 1.0);
  p.unknowns[0].start = std::numeric_limits<double>::quiet_NaN();
  p.unknowns[0].prior_sd = 1e-200;
  const Data data{Eigen::VectorXd(), Eigen::VectorXd::Constant(1, 0.1)};
  const std::string own = solve(p, data, Eigen::VectorXd::Constant(1, p.unknowns[0].start)).reason;
  EXPECT_NE(own, solve(p, data, drawn_start(p, 1)).reason);
  try {
    solve_from_starts(p, data, 1);
    FAIL();
  } catch (const RunError& e) {
    const std::string text = e.what();
    EXPECT_EQ(
        text.rfind("the fit converges from none of 21 starts. From the start of the case: " + own,
                   0),
        0u)
        << text;
  }
}

/// A law within its usual values.
forces::HansonHansen drawn_law(Random& random) {
  forces::HansonHansen law;
  law.A1 = random.uniform(0.5, 2.0);
  law.A2 = random.uniform(0.0, 1.0);
  law.A3 = random.uniform(10 * degree, 35 * degree);
  law.A4 = random.uniform(0.0, 1.5);
  law.A5 = random.uniform(0.5, 2.0);
  law.A6 = random.uniform(0.2, 0.8);
  law.pressure_share = random.uniform(0.5, 1.2);
  return law;
}

/// Share of the objective; seen 8.4e-10, where golden sections of the twin end.
constexpr double same_objective = 2.5e-9;

void expect_the_twins_objective(CalibrationCase c, std::uint64_t seed,
                                const reference::SevenPriors& priors = {}) {
  Random random{seed};
  const forces::HansonHansen law = drawn_law(random);
  c.noise = {.reading = 0.03, .test = 0.02, .rop = 0.02};
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, law, {0.03, 0.02}, random.next());
  const Problem p = fitted_problem(c, cuts);
  const Solution s = solve_from_starts(p, data_of(p), 1);
  const auto twin = reference::variable_projection(
      twin_readings(p, c.noise), twin_coefficients(p.law), {0.0, 45 * degree, 0.0, 2.0}, priors);
  EXPECT_NEAR(s.chi2, twin.objective, same_objective * twin.objective) << seed;
}

TEST(Solve, finds_the_objective_of_variable_projection) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) expect_the_twins_objective(made_up_case(), seed);
}

TEST(Solve, finds_it_with_priors) {
  CalibrationCase c = made_up_case();
  reference::SevenPriors priors;
  for (std::size_t k = 0; k < priors.size(); ++k) {
    c.unknowns[k].prior_sd = 0.6 * c.unknowns[k].start;
    priors[k] = {c.unknowns[k].start, c.unknowns[k].prior_sd};
  }
  for (std::uint64_t seed = 11; seed <= 14; ++seed) expect_the_twins_objective(c, seed, priors);
}

}  // namespace
}  // namespace tdbd::calibration::solve_test

#include "calibration/fit/problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibration/made_up_laboratory.hpp"
#include "calibration/twin_readings.hpp"

namespace tdbd::calibration::problem_test {
namespace {

CalibrationCase noisy_case() {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03, .test = 0.03, .rop = 0.02};
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.03}, 5);
  return c;
}

Fit fit_of(const CalibrationCase& c) {
  return fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
}

/// Relative, of the twin's objective and whitening;.
TEST(Problem, its_blocks_are_the_covariance_of_all_readings_in_one) {
  CalibrationCase c = noisy_case();
  for (Record& r : c.records.rows)
    r.readings[turning].deviation = 0.05 * *r.readings[turning].value;
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const auto n = static_cast<Eigen::Index>(p.readings());
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(n, n);
  for (const TestBlock& b : p.blocks)
    blocks.block(b.first, b.first, b.factor.rows(), b.factor.rows()) =
        b.factor * b.factor.transpose();
  const Eigen::MatrixXd dense = twin_readings(p, c.noise).covariance;
  constexpr double share_of_largest = 1e-6;
  EXPECT_LT((blocks - dense).cwiseAbs().maxCoeff(), share_of_largest * dense.maxCoeff());
}

TEST(Problem, its_loads_are_the_twins) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Eigen::VectorXd logs = log_loads(p, hidden_law());
  constexpr double rounding = 2e-14;
  for (std::size_t i = 0; i < p.readings(); ++i) {
    const auto [sample, load] = p.places[i];
    const Eigen::Vector2d twin =
        reference::loads(p.samples[sample].cuts, twin_coefficients(hidden_law()));
    EXPECT_NEAR(logs[static_cast<Eigen::Index>(i)], std::log(twin[static_cast<Eigen::Index>(load)]),
                rounding);
  }
}

/// Relative, of the coefficients; seen 2.1e-8. A search that goes by the sum of squares cannot tell
/// values nearer than the root of rounding.
constexpr double same_fit = 6e-8;
/// Of the objective; seen 1e-15.
constexpr double same_objective = 3e-14;

TEST(Problem, the_order_of_rows_does_not_matter) {
  CalibrationCase c = noisy_case();
  const Fit before = fit_of(c);
  std::reverse(c.records.rows.begin(), c.records.rows.end());
  std::rotate(c.records.rows.begin(), c.records.rows.begin() + 5, c.records.rows.end());
  const Fit after = fit_of(c);
  EXPECT_LT(relative_difference(after.values, before.values), same_fit);
  EXPECT_NEAR(after.chi2, before.chi2, same_objective * before.chi2);
}

TEST(Problem, names_of_tests_do_not_matter) {
  CalibrationCase c = noisy_case();
  const Fit before = fit_of(c);
  for (Record& r : c.records.rows) r.test = "z" + std::string(r.test.rbegin(), r.test.rend());
  EXPECT_LT(relative_difference(fit_of(c).values, before.values), same_fit);
}

/// Half the width of the edge with twice the stress is the same law, exactly.
TEST(Problem, the_edges_width_and_its_stress_are_one_coefficient) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  forces::HansonHansen law = hidden_law();
  const Eigen::VectorXd before = log_loads(p, law);
  law.te *= 2.0;
  law.A4 /= 2.0;
  constexpr double rounding = 1e-14;
  EXPECT_LT((log_loads(p, law) - before).cwiseAbs().maxCoeff(), rounding);
}

TEST(Problem, an_empty_load_is_no_reading) {
  CalibrationCase c = noisy_case();
  const std::size_t all = fitted_problem(c, made_up_cuts(c)).readings();
  for (Record& r : c.records.rows) r.readings[turning].value.reset();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  EXPECT_EQ(2 * p.readings(), all);
  EXPECT_TRUE(std::ranges::all_of(p.places, [](const auto& at) { return at.load == axial; }));
}

}  // namespace
}  // namespace tdbd::calibration::problem_test

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

/// Parts with laws of their own count, and priors.
TEST(Problem, has_the_rows_of_all_parts_where_one_unknown_moves) {
  CalibrationCase c = noisy_case();
  c.unknowns.front().prior_sd = 0.5;
  Problem p = fitted_problem(c, made_up_cuts(c));
  for (Sample& s : p.samples) s.others = {900.0, 40.0};
  const Eigen::VectorXd values = truth_of(p, hidden_law());
  const Data nothing{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p.readings())),
                     Eigen::VectorXd::Zero(values.size())};
  constexpr double rounding = 1e-15;  // of the rows' norm
  OneMoves moves(p, values);
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    Eigen::VectorXd moved = values;
    moved[k] *= 1.1;
    const Eigen::VectorXd all = residuals_at(p, nothing, moved);
    EXPECT_LT((moves.residuals(k, moved[k]) - all).norm(), rounding * all.norm()) << k;
  }
}

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
  constexpr double share_of_largest = 1.6e-9;
  EXPECT_LT((blocks - dense).cwiseAbs().maxCoeff(), share_of_largest * dense.maxCoeff());
}

TEST(Problem, its_loads_are_the_twins) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Eigen::VectorXd logs = log_loads(p, hidden_law());
  constexpr double rounding = 5e-15;
  for (std::size_t i = 0; i < p.readings(); ++i) {
    const auto [sample, load] = p.places[i];
    const Eigen::Vector2d twin =
        reference::loads(p.samples[sample].cuts, twin_coefficients(hidden_law()));
    EXPECT_NEAR(logs[static_cast<Eigen::Index>(i)], std::log(twin[static_cast<Eigen::Index>(load)]),
                rounding);
  }
}

/// Relative, of the coefficients; seen 2.2e-11.
constexpr double same_fit = 6e-11;

TEST(Problem, the_order_of_rows_does_not_matter) {
  CalibrationCase c = noisy_case();
  const Fit before = fit_of(c);
  std::reverse(c.records.rows.begin(), c.records.rows.end());
  for (int turn = 0; turn < 8; ++turn) {
    std::rotate(c.records.rows.begin(), c.records.rows.begin() + 5, c.records.rows.end());
    const Fit after = fit_of(c);
    EXPECT_LT(relative_difference(after.values, before.values), same_fit);
  }
}

/// A number that went through another unit differs in its last digit.
TEST(Problem, units_of_readings_do_not_matter) {
  CalibrationCase c = noisy_case();
  const Fit before = fit_of(c);
  for (Record& r : c.records.rows) {
    r.pressure = r.pressure / 6894.757293168361 * 6894.757293168361;
    r.rate = r.rate * 3600.0 / 3600.0;
    for (Reading& reading : r.readings)
      reading.value = *reading.value / 4.4482216152605 * 4.4482216152605 * (1.0 + 2e-16);
  }
  const Fit after = fit_of(c);
  EXPECT_LT(relative_difference(after.values, before.values), 2.7e-11);
}

TEST(Problem, names_of_tests_do_not_matter) {
  CalibrationCase c = noisy_case();
  const Fit before = fit_of(c);
  for (Record& r : c.records.rows) r.test = "z" + std::string(r.test.rbegin(), r.test.rend());
  EXPECT_EQ(relative_difference(fit_of(c).values, before.values), 0.0);
}

/// Half the width of the edge with twice the stress is the same law, exactly.
TEST(Problem, the_edges_width_and_its_stress_are_one_coefficient) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  forces::HansonHansen law = hidden_law();
  const Eigen::VectorXd before = log_loads(p, law);
  law.te *= 2.0;
  law.A4 /= 2.0;
  constexpr double rounding = 1e-15;
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

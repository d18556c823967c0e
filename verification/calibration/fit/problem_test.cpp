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
  SingleChange moves(p, values);
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

/// Derivatives of fourth order in steps of a thousandth of each value, straight from the loads.
Eigen::MatrixXd wide_derivatives(const Problem& p, const Data& data,
                                 const Eigen::VectorXd& values) {
  Eigen::MatrixXd J(p.rows(), values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const double h = 1e-3 * values[k];
    const auto at = [&](double step) {
      Eigen::VectorXd moved = values;
      moved[k] += step;
      return residuals_at(p, data, moved);
    };
    J.col(k) = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
  }
  return J;
}

/// Relative to the norm of a column: of the first or the second order in steps of 1e-5.
double difference(const Problem& p, const Data& data, const Eigen::VectorXd& values,
                  Difference order) {
  const Eigen::MatrixXd twin = wide_derivatives(p, data, values), J = jacobian_at(p, values, order);
  return ((J - twin).colwise().norm().array() / twin.colwise().norm().array()).maxCoeff();
}

/// With the priors' rows among the others.
TEST(Jacobian, is_of_second_order_or_of_first_for_half_the_price) {
  CalibrationCase c = noisy_case();
  c.unknowns[1].prior_sd = 0.3;
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Data data = data_of(p);
  const Eigen::VectorXd values = truth_of(p, hidden_law());
  EXPECT_LT(difference(p, data, values, Difference::central), 2.5e-9);    // 8e-10 seen
  EXPECT_LT(difference(p, data, values, Difference::one_sided), 1.3e-5);  // 5e-6 seen
  EXPECT_GT(difference(p, data, values, Difference::one_sided), 1e-7);
}

/// The step goes with the value, also where that is far below its start.
TEST(Jacobian, has_its_digits_far_below_the_starts) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Eigen::VectorXd values = 3e-3 * truth_of(p, hidden_law());
  EXPECT_LT(difference(p, data_of(p), values, Difference::one_sided), 7e-6);  // 3e-6 seen
}

/// At 0, the end of a range, a thousandth of the start stands for the value, and the difference goes inwards.
TEST(Jacobian, is_one_sided_at_the_end_of_a_range) {
  const CalibrationCase c = noisy_case();
  const Problem p = fitted_problem(c, made_up_cuts(c));
  Eigen::VectorXd values = truth_of(p, hidden_law());
  const Eigen::Index A6 = 3;
  ASSERT_EQ(p.unknowns[A6].key, "A6");
  values[A6] = 0.0;
  Eigen::VectorXd inside = values;
  inside[A6] = 1e-3;
  const Eigen::MatrixXd at_end = jacobian_at(p, values), near = jacobian_at(p, inside);
  EXPECT_TRUE(at_end.allFinite());
  EXPECT_LT((at_end.col(A6) - near.col(A6)).norm(), 9e-4 * near.col(A6).norm());
}

/// The variances of a reading, of its test and of the rate add up; a deviation of the reading
/// itself replaces the default.
TEST(ReadingVariance, adds_up_what_is_uncertain) {
  const Noise noise{.reading = 0.03, .test = 0.04, .rop = 0.05};
  EXPECT_DOUBLE_EQ(reading_variance(noise, {}, 0.0), 9e-4 + 16e-4);
  EXPECT_DOUBLE_EQ(reading_variance(noise, {}, 2.0), 9e-4 + 16e-4 + 4.0 * 25e-4);
  EXPECT_DOUBLE_EQ(reading_variance(noise, {200.0, 12.0}, 0.0), 36e-4 + 16e-4);
}

}  // namespace
}  // namespace tdbd::calibration::problem_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/fit/quality.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace tdbd::calibration::identifiability_test {
namespace {

CalibrationCase read_case(CalibrationCase c) {
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.0}, 3);
  return c;
}

/// Whitened derivatives with respect to relative changes, straight from the loads.
Eigen::MatrixXd relative_derivatives(const Problem& p, const Eigen::VectorXd& values,
                                     double reading) {
  Eigen::MatrixXd J(static_cast<Eigen::Index>(p.readings()), values.size());
  constexpr double step = 1e-5;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    Eigen::VectorXd more = values, less = values;
    more[k] *= 1.0 + step;
    less[k] *= 1.0 - step;
    J.col(k) =
        (log_loads(p, law_at(p, more)) - log_loads(p, law_at(p, less))) / (2 * step * reading);
  }
  return J;
}

/// The least of |J v| over unit v, by going down the inverse of J^T J again and again.
double least_stretch(const Eigen::MatrixXd& J) {
  const Eigen::MatrixXd N = J.transpose() * J;
  Eigen::VectorXd v = Eigen::VectorXd::Ones(N.cols());
  for (int i = 0; i < 200; ++i) v = N.fullPivLu().solve(v).normalized().eval();
  return (J * v).norm();
}

TEST(Identifiability, the_weakest_direction_stretches_least) {
  const CalibrationCase c = read_case(made_up_case());
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Eigen::VectorXd values = truth_of(p, hidden_law());
  const Identifiability found = identifiability_at(p, values);
  const Eigen::MatrixXd J = relative_derivatives(p, values, c.noise.reading);
  constexpr double squared_condition = 1.1e-9;
  EXPECT_NEAR(found.singular_values.back() / least_stretch(J), 1.0, squared_condition);
  const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(found.weakest_direction.data(), 7);
  EXPECT_NEAR((J * v).norm() / found.singular_values.back(), 1.0, squared_condition);
  EXPECT_NEAR(v.norm(), 1.0, 1e-14);
  for (std::size_t k = 1; k < 7; ++k)
    EXPECT_LE(found.singular_values[k], found.singular_values[k - 1]);
}

/// Of the two signs that of the largest component, whichever it is.
TEST(Identifiability, is_not_computed_without_fitted_coefficients) {
  const Problem nothing;
  EXPECT_NO_THROW(require_identifiable(nothing));
  EXPECT_EQ(in_words(nothing, {}), "nothing was fitted");
}

/// Shares relative to the largest component, in any position; a share below 3 % is ignored.
TEST(Identifiability, of_a_direction_names_every_unknown_that_counts) {
  Problem p;
  p.unknowns.resize(4);
  for (std::size_t k = 0; k < 4; ++k) p.unknowns[k].key = std::string(1, "abcd"[k]);
  const auto told = [&](std::vector<double> direction) {
    return in_words(p, {{5.0, 2.0, 1.0, 0.25}, std::move(direction)});
  };
  EXPECT_EQ(
      told({0.25, 0.5, -0.125, 0.01}),
      "b +100 %, a +50 %, c -25 %: this changes all readings together by 0.5 times their noise");
  EXPECT_EQ(
      told({-0.01, 0.25, 0.25, 0.5}),
      "d +100 %, b +50 %, c +50 %: this changes all readings together by 0.5 times their noise");
}

TEST(Identifiability, the_weakest_direction_points_up) {
  CalibrationCase c = read_case(made_up_case());
  Random random{3};
  for (int i = 0; i < 12; ++i) {
    std::rotate(c.unknowns.begin(), c.unknowns.begin() + 1, c.unknowns.end());
    const Problem p = fitted_problem(c, made_up_cuts(c));
    Eigen::VectorXd values = truth_of(p, hidden_law());
    for (double& x : values) x *= random.uniform(0.6, 1.4);
    const std::vector<double> v = identifiability_at(p, values).weakest_direction;
    const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
    EXPECT_GT(*std::ranges::max_element(v, less), 0.0) << i;
  }
}

TEST(Identifiability, squares_of_singular_values_sum_up_to_those_of_the_derivatives) {
  const CalibrationCase c = read_case(made_up_case());
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Eigen::VectorXd values = truth_of(p, hidden_law());
  double sum = 0.0;
  for (const double s : identifiability_at(p, values).singular_values) sum += s * s;
  const double all = relative_derivatives(p, values, c.noise.reading).squaredNorm();
  constexpr double differences = 5.3e-11;
  EXPECT_NEAR(sum / all, 1.0, differences);
}

std::string refusal(const CalibrationCase& c) {
  try {
    require_identifiable(fitted_problem(c, made_up_cuts(c)));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// Unknown te beside A4.
CalibrationCase with_both_of_the_edge() {
  CalibrationCase c = read_case(made_up_case());
  c.unknowns.push_back({"te", 1e-4, {}, Range::non_negative(), "case.toml:8: unknowns.te"});
  return c;
}

TEST(Identifiability, the_edges_width_and_its_stress_are_rejected_by_name) {
  const std::string message = refusal(with_both_of_the_edge());
  EXPECT_NE(message.find("te"), std::string::npos) << message;
  EXPECT_NE(message.find("A4"), std::string::npos) << message;
  EXPECT_NE(message.find("found a direction that the records do not determine"), std::string::npos)
      << message;
  EXPECT_NE(message.find("expected a prior_sd for one of them, or one of them in [fixed]"),
            std::string::npos)
      << message;
}

TEST(Identifiability, a_prior_for_one_of_them_helps) {
  CalibrationCase c = with_both_of_the_edge();
  unknown(c, "te")->prior_sd = 1e-5;
  EXPECT_EQ(refusal(c), "");
}

TEST(Identifiability, a_coefficient_that_no_part_uses_is_rejected) {
  CalibrationCase c = read_case(made_up_case());
  c.unknowns.push_back({"A7", 1.0, {}, Range::non_negative(), "case.toml:8: unknowns.A7"});
  EXPECT_EQ(
      refusal(c),
      "case.toml:8: unknowns.A7: found a coefficient that acts on no part of the fitted bits (it "
      "acts on cse or cutter body), expected it in [fixed]");
}

TEST(Identifiability, what_would_help_is_told) {
  CalibrationCase c = read_case(made_up_case());
  std::erase_if(c.records.rows, [](const Record& r) { return r.pressure > 30e6; });
  for (Record& r : c.records.rows) r.readings[turning].value.reset();
  const std::string message = refusal(c);
  EXPECT_NE(message.find("a torque (or drag) reading, a test at another pressure, a prior_sd"),
            std::string::npos)
      << message;
}

TEST(Identifiability, seven_coefficients_are_seen) {
  const CalibrationCase c = read_case(made_up_case());
  EXPECT_EQ(refusal(c), "");
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const auto values = truth_of(p, hidden_law());
  const std::string words = in_words(p, identifiability_at(p, values));
  EXPECT_NE(words.find(" +100 %, "), std::string::npos) << words;
}

}  // namespace
}  // namespace tdbd::calibration::identifiability_test

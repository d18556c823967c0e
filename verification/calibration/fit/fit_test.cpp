#include "calibration/fit/fit.hpp"

#include <gsl/gsl_errno.h>
#include <gtest/gtest.h>

#include "calibration/fit/trust_region.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "calibration/twin_readings.hpp"

namespace tdbd::calibration::fit_test {
namespace {

/// Relative to the two standard errors; derivatives are differences in both. Seen 1.1e-9.
constexpr double same_covariance = 3e-9;

void expect_the_dense_covariance(const CalibrationCase& c, const reference::Priors& priors) {
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Fit f = fit(p, c.intervals);
  const Eigen::MatrixXd twin = reference::covariance_of_coefficients(
      twin_derivatives(p, f.law), twin_readings(p, c.noise).covariance, priors);
  for (Eigen::Index i = 0; i < twin.rows(); ++i)
    for (Eigen::Index j = 0; j < twin.rows(); ++j)
      EXPECT_NEAR(f.covariance(i, j), twin(i, j),
                  same_covariance * std::sqrt(twin(i, i) * twin(j, j)))
          << i << " " << j;
}

CalibrationCase noisy(CalibrationCase c) {
  c.noise = {.reading = 0.03, .test = 0.03, .rop = 0.02};
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.03}, 5);
  return c;
}

TEST(Covariance, is_that_of_one_dense_matrix) {
  const CalibrationCase c = noisy(well_conditioned_case());
  expect_the_dense_covariance(c, reference::Priors(c.unknowns.size()));
}

TEST(Covariance, with_priors_is_that_of_one_dense_matrix) {
  CalibrationCase c = made_up_case();
  reference::Priors priors;
  for (Unknown& u : c.unknowns) priors.push_back(u.prior_sd = 0.5 * u.start);
  expect_the_dense_covariance(noisy(c), priors);
}

/// Fits with priors of this share of the starts.
Fit with_priors(CalibrationCase c, double share) {
  for (Unknown& u : c.unknowns) u.prior_sd = share * u.start;
  return fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
}

TEST(Fit, reports_whether_a_coefficient_comes_from_its_prior) {
  const CalibrationCase c = noisy(well_conditioned_case());
  for (const FittedCoefficient& k : with_priors(c, 1e-3).coefficients) {
    EXPECT_TRUE(k.from_prior) << k.key;
    EXPECT_NEAR(k.value, k.start, 0.003 * k.start) << k.key;
  }
  for (const FittedCoefficient& k : with_priors(c, 10.0).coefficients)
    EXPECT_FALSE(k.from_prior) << k.key;
}

/// The truth of A5 is below its range: the fit ends at the bound, without an interval, and
/// determines all others.
TEST(Fit, a_coefficient_at_its_bound_has_no_interval) {
  CalibrationCase c = noisy(well_conditioned_case());
  Unknown& A5 = *unknown(c, "A5");
  A5.range = Range::within(2.0, 5.0);
  A5.start = 3.0;
  const Fit f = fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
  for (const FittedCoefficient& k : f.coefficients) {
    EXPECT_EQ(k.at_bound, k.key == "A5");
    EXPECT_EQ(k.se == 0.0, k.key == "A5");
    EXPECT_EQ(k.low < k.value && k.value < k.high, k.key != "A5");
  }
  EXPECT_EQ(f.values[2], end_of(A5, 2.0));
}

/// Of noisy readings the search ends where it no longer moves, and not after all its iterations.
TEST(Fit, its_search_stops_where_it_is_done) {
  const CalibrationCase c = noisy(well_conditioned_case());
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Data data = data_of(p);
  Search search{p, data, truth_of(p, hidden_law()), {}};
  for (Eigen::Index k = 0; k < search.values.size(); ++k) search.free.push_back(k);
  EXPECT_EQ(search_from_values(search), GSL_SUCCESS);
  EXPECT_LT(search.evaluations, 61);
}

/// A place that was polished needs one more step to be known as such: four evaluations for each derivative.
TEST(Fit, its_polish_counts_its_evaluations) {
  const CalibrationCase c = noisy(well_conditioned_case());
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Data data = data_of(p);
  Search search{p, data, solve(p, data, truth_of(p, hidden_law())).values, {}};
  for (Eigen::Index k = 0; k < search.values.size(); ++k) search.free.push_back(k);
  polish(search);
  const long before = search.evaluations;
  polish(search);
  EXPECT_EQ(search.evaluations - before, 4 * search.values.size());
}

/// The search alone reports that a variable left its range; `fit` then removes the unknown.
TEST(Fit, its_search_stops_where_a_coefficient_is_driven_out) {
  CalibrationCase c = noisy(well_conditioned_case());
  Unknown& A5 = *unknown(c, "A5");
  A5.range = Range::within(2.0, 5.0);
  A5.start = 3.0;
  const Problem p = fitted_problem(c, made_up_cuts(c));
  const Data data = data_of(p);
  Eigen::VectorXd start(static_cast<Eigen::Index>(p.unknowns.size()));
  for (Eigen::Index k = 0; k < start.size(); ++k)
    start[k] = p.unknowns[static_cast<std::size_t>(k)].start;
  Search search{p, data, start, {}};
  for (Eigen::Index k = 0; k < start.size(); ++k) search.free.push_back(k);
  EXPECT_EQ(search_from_values(search), GSL_CONTINUE);
  EXPECT_TRUE(is_at_bound(A5.range, search.values[2], A5.start));
}

TEST(Fit, its_objectives_are_sums_of_squared_deviations) {
  CalibrationCase c = well_conditioned_case();
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.0}, 5);
  const Fit f = fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
  constexpr double rounding = 1e-15;
  EXPECT_NEAR(f.objectives[axial] + f.objectives[turning], f.chi2, rounding * f.chi2);
  EXPECT_EQ(f.degrees_of_freedom, 32 - 5);
  EXPECT_NEAR(std::sqrt(f.errors.squaredNorm() / (32 - 5)), 0.03, 0.01);  // the noise
  EXPECT_NEAR(f.chi2, f.errors.squaredNorm() / (0.03 * 0.03), rounding * f.chi2);
}

TEST(Fit, the_quantile_of_95_percent_is_1_96) {
  EXPECT_NEAR(two_sided_quantile(0.95), 1.959963984540054, 1e-14);
  EXPECT_NEAR(two_sided_quantile(0.5), 0.674489750196082, 1e-14);
}

}  // namespace
}  // namespace tdbd::calibration::fit_test

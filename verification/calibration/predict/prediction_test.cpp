#include "calibration/predict/prediction.hpp"

#include <gtest/gtest.h>

#include "calibration/made_up_laboratory.hpp"

namespace tdbd::calibration::prediction_test {
namespace {

constexpr int seeds = 400;

/// How often intervals of 95 % hold what they are for.
struct Coverage {
  double coefficients = 0.0, loads = 0.0;
};

bool is_inside(double low, double x, double high) { return low <= x && x <= high; }

/// Share of the coefficients of a fit whose interval holds the truth.
double share_of_coefficients(const Fit& f, const Eigen::VectorXd& truth) {
  double inside = 0.0;
  for (std::size_t k = 0; k < f.coefficients.size(); ++k)
    inside += is_inside(f.coefficients[k].low, truth[static_cast<Eigen::Index>(k)],
                        f.coefficients[k].high);
  return inside / static_cast<double>(f.coefficients.size());
}

/// Share of the readings of the withheld bit that lie in their intervals.
double share_of_loads(const Fit& f, const CalibrationCase& c, const CutStore& cuts) {
  double inside = 0.0, all = 0.0;
  for (const Record& r : records_of(c, c.predict)) {
    const Sample s = sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), c.law);
    const Prediction p = predict(f, s, r, c.noise, {}, c.intervals.level);
    for (const std::size_t k : {axial, turning}) {
      inside += is_inside(p.loads[k].low, *r.readings[k].value, p.loads[k].high);
      all += 1.0;
    }
  }
  return inside / all;
}

/// (6): the interval of log load widens by the discrepancy of its own load.
TEST(Prediction, has_the_discrepancy_in_its_interval) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law(), {0.03, 0.0}, 7);
  const Fit f = fit(fitted_problem(c, cuts), c.intervals);
  const Record r = records_of(c, c.predict).front();
  const Sample s = sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), c.law);
  const Discrepancy wrong{{0.1, 0.25}, ""};
  const Prediction without = predict(f, s, r, c.noise, {}, c.intervals.level);
  const Prediction with = predict(f, s, r, c.noise, wrong, c.intervals.level);
  const double z = two_sided_quantile(c.intervals.level);
  constexpr double rounding = 1e-15;  // of a variance of 0.01
  for (const std::size_t k : {axial, turning}) {
    const auto variance = [&](const Prediction& p) {
      return std::pow(std::log(p.loads[k].high / p.loads[k].mean) / z, 2);
    };
    EXPECT_NEAR(variance(with) - variance(without), wrong.value[k] * wrong.value[k], rounding);
    EXPECT_EQ(with.loads[k].se, without.loads[k].se);
  }
}

/// Over many laboratories with one noise, fitted by a case that knows of it or not.
Coverage coverage(CalibrationCase c, const LaboratoryNoise& noise) {
  const CutStore cuts = made_up_cuts(c);
  Coverage mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    read_loads(c, cuts, hidden_law(), noise, static_cast<std::uint64_t>(seed));
    const Problem p = fitted_problem(c, cuts);
    const Fit f = fit(p, c.intervals);
    mean.coefficients += share_of_coefficients(f, truth_of(p, hidden_law())) / seeds;
    mean.loads += share_of_loads(f, c, cuts) / seeds;
  }
  return mean;
}

/// 400 laboratories determine a share to 0.01.
void expect_good(const Coverage& seen) {
  EXPECT_TRUE(is_inside(0.91, seen.coefficients, 0.985)) << seen.coefficients;
  EXPECT_TRUE(is_inside(0.91, seen.loads, 0.985)) << seen.loads;
}

TEST(Coverage, of_independent_noise) {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03};
  expect_good(coverage(c, {0.03, 0.0}));
}

TEST(Coverage, of_a_factor_common_to_a_test) {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03, .test = 0.04};
  expect_good(coverage(c, {0.03, 0.04}));
}

/// Intervals that do not know of a factor of 4 % hold too little.
TEST(Coverage, fails_where_the_factor_is_ignored) {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03};
  const Coverage seen = coverage(c, {0.03, 0.04});
  EXPECT_LT(seen.coefficients, 0.8);
  EXPECT_LT(seen.loads, 0.8);
}

/// All seven are free; what is true was drawn from the priors.
TEST(Coverage, of_seven_coefficients_with_priors) {
  CalibrationCase c = made_up_case();
  const CutStore cuts = made_up_cuts(c);
  for (Unknown& u : c.unknowns) u.prior_sd = 0.25 * u.start;
  Random random{1};
  Coverage mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    const forces::Law truth = drawn_from_priors(c, random);
    read_loads(c, cuts, truth, {0.03, 0.0}, random.next());
    const Problem p = fitted_problem(c, cuts);
    const Fit f = fit(p, c.intervals);
    mean.coefficients += share_of_coefficients(f, truth_of(p, truth)) / seeds;
    mean.loads += share_of_loads(f, c, cuts) / seeds;
  }
  expect_good(mean);
}

TEST(Prediction, its_standard_error_is_that_of_the_loads_derivatives) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law(), {0.03, 0.0}, 2);
  const Fit f = fit(fitted_problem(c, cuts), c.intervals);
  const Record r = records_of(c, c.predict).front();
  const Sample s = sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), c.law);
  const Prediction p = predict(f, s, r, c.noise, {}, 0.95);
  constexpr double step = 1e-3, second_order = 2.6e-7;
  for (const std::size_t k : {axial, turning}) {
    Eigen::VectorXd g(f.values.size());
    for (Eigen::Index i = 0; i < g.size(); ++i) {
      Eigen::VectorXd more = f.values, less = f.values;
      more[i] += step * f.values[i];
      less[i] -= step * f.values[i];
      g[i] =
          (mean_loads(law_at(f.problem, more), s)[k] - mean_loads(law_at(f.problem, less), s)[k]) /
          (2.0 * step * f.values[i]);
    }
    const double se = std::sqrt(g.dot(f.covariance * g));
    EXPECT_NEAR(p.loads[k].se, se, second_order * se);
    EXPECT_NEAR(p.loads[k].mean, mean_loads(f.law, s)[k], 1e-12 * p.loads[k].mean);
    const double reach = std::hypot(se / p.loads[k].mean, c.noise.reading);
    const double of_reach = std::pow(se / p.loads[k].mean / reach, 2) * second_order;
    EXPECT_NEAR(std::log(p.loads[k].high / p.loads[k].mean), 1.959963984540054 * reach,
                1.96 * of_reach * reach);
    EXPECT_NEAR(p.loads[k].high * p.loads[k].low, p.loads[k].mean * p.loads[k].mean,
                1e-12 * p.loads[k].mean * p.loads[k].mean);
  }
}

Prediction with_error(double error) {
  Prediction p;
  p.record.readings[axial].value = 1e4;
  p.loads[axial].mean = 1e4 * (1.0 + error);
  return p;
}

TEST(Prediction, errors_are_the_root_of_mean_squares_and_the_95th_of_100) {
  std::vector<Prediction> all;
  double squares = 0.0;
  for (int i = 100; i >= 1; --i) {
    all.push_back(with_error((i % 2 == 0 ? 1e-3 : -1e-3) * i));
    squares += 1e-6 * i * i;
  }
  const auto errors = errors_of(all);
  EXPECT_NEAR(errors[axial].rms, std::sqrt(squares / 100), 1e-12);
  EXPECT_NEAR(errors[axial].p95, 0.095, 1e-12);
  EXPECT_EQ(errors[axial].readings, 100);
  EXPECT_EQ(errors[turning].readings, 0);
}

/// Of few readings the 95th percentile is the largest error, from 20 on the one below it.
TEST(Prediction, the_95th_percentile_of_few_is_the_largest) {
  for (const int n : {1, 2, 19, 20, 21, 40}) {
    std::vector<Prediction> all;
    for (int i = 1; i <= n; ++i) all.push_back(with_error(1e-3 * i));
    const int place = n < 20 ? n : (19 * n + 19) / 20;
    EXPECT_NEAR(errors_of(all)[axial].p95, 1e-3 * place, 1e-12) << n;
  }
}

/// A load that nothing reads and whose coefficients are all held scatters by noise alone.
TEST(Prediction, of_coefficients_at_bounds_has_no_standard_error) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law(), {0.03, 0.0}, 2);
  Fit f = fit(fitted_problem(c, cuts), c.intervals);
  f.covariance.setZero();
  const Record r = records_of(c, c.predict).front();
  const Sample s = sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), c.law);
  for (const PredictedLoad& load : predict(f, s, r, c.noise, {}, 0.95).loads) {
    EXPECT_EQ(load.se, 0.0);
    EXPECT_NEAR(std::log(load.high / load.mean), 1.959963984540054 * c.noise.reading, 1e-14);
  }
}

}  // namespace
}  // namespace tdbd::calibration::prediction_test

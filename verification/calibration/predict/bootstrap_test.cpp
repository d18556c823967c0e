#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/fit/fit.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "calibration/predict/prediction.hpp"
#include "core/random.hpp"

namespace tdbd::calibration::bootstrap_test {
namespace {

Fit good_fit() {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.02, .test = 0.02};
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law(), {0.02, 0.02}, 8);
  return fit(fitted_problem(c, cuts), c.intervals);
}

TEST(Bootstrap, the_same_seed_gives_the_same_numbers) {
  const Fit f = good_fit();
  const Bootstrap a = bootstrap(f, {0.95, 20, 7}), b = bootstrap(f, {0.95, 20, 7}),
                  other = bootstrap(f, {0.95, 20, 8});
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) {
    EXPECT_EQ(a.coefficients[k].mean, b.coefficients[k].mean);
    EXPECT_EQ(a.coefficients[k].low, b.coefficients[k].low);
    EXPECT_NE(a.coefficients[k].mean, other.coefficients[k].mean);
  }
}

/// 400 replicates determine a standard error to 3.5 %.
TEST(Bootstrap, its_standard_errors_are_those_of_the_derivatives) {
  const Fit f = good_fit();
  const Bootstrap b = bootstrap(f, {0.95, 400, 1});
  EXPECT_EQ(b.failed, 0);
  constexpr double same_se = 0.14;
  for (std::size_t k = 0; k < b.coefficients.size(); ++k) {
    EXPECT_NEAR(b.coefficients[k].se / f.coefficients[k].se, 1.0, same_se) << f.coefficients[k].key;
    EXPECT_NEAR(b.coefficients[k].mean, f.coefficients[k].value, 0.3 * f.coefficients[k].se);
    EXPECT_LT(b.coefficients[k].low, b.coefficients[k].mean);
    EXPECT_GT(b.coefficients[k].high, b.coefficients[k].mean);
  }
}

TEST(Bootstrap, of_one_replicate_scatters_by_nothing) {
  for (const BootstrapSummary& f : bootstrap(good_fit(), {0.95, 1, 3}).coefficients) {
    EXPECT_EQ(f.low, f.mean);
    EXPECT_EQ(f.high, f.mean);
  }
}

/// Mean, deviation and quartiles of five replicates, computed independently from their fits:
/// sorted, the second and the fourth.
TEST(Bootstrap, has_the_figures_of_its_replicates) {
  const Fit f = good_fit();
  const Bootstrap b = bootstrap(f, {0.5, 5, 7});
  ASSERT_EQ(b.replicates, 5);
  ASSERT_EQ(b.failed, 0);
  Random seeds{7};
  std::vector<Eigen::VectorXd> fits;
  for (int i = 0; i < 5; ++i) {
    const Data drawn = drawn_data(f.problem, f.values, seeds.next());
    fits.push_back(solve(f.problem, drawn, f.values, Precision::replicate).values);
  }
  for (std::size_t k = 0; k < b.coefficients.size(); ++k) {
    std::vector<double> v;
    for (const Eigen::VectorXd& values : fits) v.push_back(values[static_cast<Eigen::Index>(k)]);
    std::ranges::sort(v);
    const double mean = (v[0] + v[1] + v[2] + v[3] + v[4]) / 5.0;
    double squares = 0.0;
    for (const double x : v) squares += (x - mean) * (x - mean);
    constexpr double rounding = 5e-15;
    EXPECT_NEAR(b.coefficients[k].mean, mean, rounding);
    EXPECT_NEAR(b.coefficients[k].se, std::sqrt(squares / 4.0), rounding);
    EXPECT_NEAR(b.coefficients[k].low, v[1], rounding);
    EXPECT_NEAR(b.coefficients[k].high, v[3], rounding);
    const Bootstrap wide = bootstrap(f, {0.75, 5, 7});  // half way between the first and the second
    EXPECT_NEAR(wide.coefficients[k].low, 0.5 * (v[0] + v[1]), rounding);
    EXPECT_NEAR(wide.coefficients[k].high, 0.5 * (v[3] + v[4]), rounding);
  }
}

/// Centres of priors are drawn around the fitted values by the priors' deviations; unknowns without
/// a prior keep their centre.
TEST(Bootstrap, draws_the_centres_of_priors) {
  CalibrationCase c = well_conditioned_case();
  unknown(c, "A3")->prior_sd = 0.1;
  read_loads(c, made_up_cuts(c), hidden_law(), {0.02, 0.0}, 8);
  const Fit f = fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
  const Eigen::Index A3 = 1;
  ASSERT_EQ(f.problem.unknowns[A3].key, "A3");
  constexpr int draws = 2000;
  double mean = 0.0, squares = 0.0;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const Eigen::VectorXd centres = drawn_data(f.problem, f.values, seed).prior_centres;
    mean += (centres[A3] - f.values[A3]) / draws;
    squares += std::pow(centres[A3] - f.values[A3], 2) / draws;
    EXPECT_EQ(centres[0], f.problem.unknowns[0].start);
  }
  // wide: three standard errors, and as much of the deviation
  EXPECT_NEAR(mean, 0.0, 3.0 * 0.1 / std::sqrt(draws));
  EXPECT_NEAR(std::sqrt(squares), 0.1, 0.1 * 0.045);
}

TEST(Bootstrap, of_no_replicates_is_not_made) {
  EXPECT_TRUE(bootstrap(good_fit(), {0.95, 0, 1}).coefficients.empty());
}

TEST(Bootstrap, drawn_readings_have_the_problems_covariance) {
  const Fit f = good_fit();
  const auto n = static_cast<Eigen::Index>(f.problem.readings());
  const Eigen::VectorXd means = log_loads(f.problem, f.law);
  constexpr int draws = 4000;
  double whitened = 0.0, common = 0.0;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    Eigen::VectorXd noise = drawn_data(f.problem, f.values, seed).log_loads - means;
    common += noise[0] * noise[1] / draws;  // two loads of one test
    whiten(f.problem, noise);
    whitened += noise.squaredNorm() / static_cast<double>(n) / draws;
  }
  EXPECT_NEAR(whitened, 1.0, 0.01);
  EXPECT_NEAR(common, 0.02 * 0.02, 0.1 * 0.02 * 0.02);
}

}  // namespace
}  // namespace tdbd::calibration::bootstrap_test

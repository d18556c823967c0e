#include "calibration/fit/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/made_up_laboratory.hpp"
#include "calibration/predict/prediction.hpp"

namespace tdbd::calibration::quality_test {
namespace {

/// Readings of the hidden law with the noise that the case states.
CalibrationCase noisy_case(std::uint64_t seed, const LaboratoryNoise& noise = {0.03, 0.0}) {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = noise.reading, .test = noise.test, .rop = 0.0};
  read_loads(c, made_up_cuts(c), hidden_law(), noise, seed);
  return c;
}

Fit fit_of(const CalibrationCase& c) {
  return fit(fitted_problem(c, made_up_cuts(c)), c.intervals);
}

FitQuality quality(const CalibrationCase& c) { return quality_of(fit_of(c)); }

/// The p value of a law that is right is uniform, so 1 of 100 fits is reported. Of 300 draws
/// Poisson's distribution with mean 3 exceeds 11 in 7 of 100000 cases, and the mean of the p values
/// deviates from one half by 4 standard errors, 0.067, in 6 of 100000.
TEST(FitQuality, rejects_one_of_a_hundred_fits_of_the_true_law) {
  constexpr int draws = 300;
  int rejected = 0;
  double sum = 0.0;
  for (int i = 0; i < draws; ++i) {
    const FitQuality q = quality(noisy_case(100 + static_cast<std::uint64_t>(i), {0.03, 0.02}));
    ASSERT_EQ(q.degrees_of_freedom, 32 - 5);
    rejected += *q.fits() ? 0 : 1;
    sum += q.p_value;
  }
  EXPECT_LE(rejected, 11);
  EXPECT_NEAR(sum / draws, 0.5, 0.067);
}

TEST(FitQuality, rejects_a_wrong_reading_and_names_it_first) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CalibrationCase c = noisy_case(seed);
    EXPECT_TRUE(*quality(c).fits()) << seed;
    const auto wrong = static_cast<std::size_t>(
        std::ranges::find(c.records.rows, "C", &Record::tool) - c.records.rows.begin() + 2);
    *c.records.rows[wrong].readings[turning].value *= 1.4;
    const Fit f = fit_of(c);
    const FitQuality q = quality_of(f);
    EXPECT_FALSE(*q.fits()) << seed << ": " << q.p_value;
    const auto worst = worst_readings(q, 2.0, 5);
    ASSERT_FALSE(worst.empty());
    EXPECT_EQ(worst.front().load, turning);
    const Record& named = f.problem.records[worst.front().record];
    EXPECT_EQ(*named.readings[turning].value, *c.records.rows[wrong].readings[turning].value);
    EXPECT_LT(worst.front().deviations, -5.0);  // measured above computed
  }
}

/// All readings of one test are too high by five deviations of its factor. Within the test they
/// agree, so only their deviations on their own are large.
TEST(FitQuality, names_a_test_that_disagrees_as_a_whole) {
  CalibrationCase c = noisy_case(3, {0.005, 0.03});
  for (Record& r : c.records.rows)
    if (r.test == "B-6000")
      for (Reading& reading : r.readings) *reading.value *= std::exp(0.3);
  const Fit f = fit_of(c);
  const auto worst = worst_readings(quality_of(f), 2.0, 4);
  ASSERT_EQ(worst.size(), 4U);
  for (const FittedReading& r : worst) {
    EXPECT_EQ(f.problem.records[r.record].test, "B-6000");
    EXPECT_LT(std::abs(r.deviations_in_test), std::abs(r.deviations));
  }
}

/// Deviations are log ratios over the noise. In a test without a common factor both measures agree,
/// and their squares sum up to the statistic.
TEST(FitQuality, of_independent_readings_has_one_measure) {
  const CalibrationCase c = noisy_case(5);
  const FitQuality q = quality(c);
  double squares = 0.0;
  for (const FittedReading& r : q.readings) {
    EXPECT_NEAR(r.deviations, std::log(r.ratio) / 0.03, 1e-12);
    EXPECT_NEAR(r.deviations, r.deviations_in_test, 1e-12);
    squares += r.deviations * r.deviations;
  }
  EXPECT_NEAR(q.statistic / squares, 1.0, 1e-12);
  const long within = std::ranges::count_if(
      q.readings, [](const FittedReading& r) { return std::abs(r.deviations) <= 2.0; });
  EXPECT_EQ(readings_within(q, 2.0), within);
  EXPECT_LE(worst_readings(q, 0.0, 100).size(), 32U);
  EXPECT_EQ(worst_readings(q, 0.0, 3).size(), 3U);
}

/// With correlated readings the measure within a test is that of the residual given all others.
TEST(FitQuality, within_a_test_follows_from_the_inverse_covariance) {
  const Fit f = fit_of(noisy_case(7, {0.02, 0.05}));
  const FitQuality q = quality_of(f);
  for (const TestBlock& b : f.problem.blocks) {
    const Eigen::MatrixXd weights = (b.factor * b.factor.transpose()).inverse();
    const Eigen::VectorXd pulled = weights * f.errors.segment(b.first, b.factor.rows());
    for (Eigen::Index i = 0; i < pulled.size(); ++i)
      EXPECT_NEAR(q.readings[static_cast<std::size_t>(b.first + i)].deviations_in_test,
                  pulled[i] / std::sqrt(weights(i, i)), 1e-9);
  }
}

TEST(FitQuality, of_as_many_coefficients_as_readings_is_not_tested) {
  Fit f = fit_of(noisy_case(1));
  f.degrees_of_freedom = 0;
  const FitQuality q = quality_of(f);
  EXPECT_FALSE(q.fits().has_value());
  EXPECT_EQ(q.p_value, 1.0);
}

/// Several fits share the false alarms, and a coefficient at its end is not free.
TEST(FitQuality, of_several_fits_shares_the_false_alarms) {
  Fit f = fit_of(noisy_case(1));
  EXPECT_EQ(quality_of(f).threshold, 0.01);
  EXPECT_EQ(quality_of(f, 4).threshold, 0.0025);
  f.coefficients.front().at_bound = true;
  EXPECT_EQ(quality_of(f).degrees_of_freedom, f.degrees_of_freedom + 1);
}

/// A prior that is missed by ten deviations counts like a reading.
TEST(FitQuality, counts_priors) {
  CalibrationCase c = noisy_case(1);
  unknown(c, "A1")->prior_sd = 0.01;
  unknown(c, "A1")->start = 0.9;
  const Fit f = fit_of(c);
  const FitQuality q = quality_of(f);
  EXPECT_NEAR(q.statistic, f.chi2 + std::pow((f.values[0] - 0.9) / 0.01, 2), 1e-9 * q.statistic);
  EXPECT_EQ(q.degrees_of_freedom, 32 + 1 - 5);
  EXPECT_FALSE(*q.fits());
}

}  // namespace
}  // namespace tdbd::calibration::quality_test

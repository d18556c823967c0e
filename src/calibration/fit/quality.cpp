#include "calibration/fit/quality.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace tdbd::calibration {
namespace {

double prior_rows(const Fit& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < f.problem.unknowns.size(); ++k) {
    const Unknown& u = f.problem.unknowns[k];
    if (u.prior_sd)
      sum += std::pow((f.values[static_cast<Eigen::Index>(k)] - u.start) / *u.prior_sd, 2);
  }
  return sum;
}

/// Residuals of one test given the others of the test: (C^-1 r)_i / sqrt((C^-1)_ii), from the
/// factor L of C.
Eigen::VectorXd conditional(const TestBlock& block, const Eigen::VectorXd& errors) {
  const Eigen::Index n = block.factor.rows();
  const Eigen::MatrixXd inverse =
      block.factor.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd weighted = inverse.transpose() * (inverse * errors.segment(block.first, n));
  return weighted.cwiseQuotient(inverse.colwise().norm().transpose());
}

std::vector<FittedReading> readings_of(const Fit& f) {
  std::vector<FittedReading> readings(f.problem.readings());
  const Eigen::VectorXd scaled = f.errors.cwiseQuotient(deviations(f.problem));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const ReadingPlace& place = f.problem.places[i];
    readings[i] = {place.sample, place.load, std::exp(f.errors[row]), scaled[row], 0.0};
  }
  for (const TestBlock& block : f.problem.blocks) {
    const Eigen::VectorXd of_block = conditional(block, f.errors);
    for (Eigen::Index i = 0; i < of_block.size(); ++i)
      readings[static_cast<std::size_t>(block.first + i)].deviations_in_test = of_block[i];
  }
  return readings;
}

double largest(const FittedReading& r) {
  return std::max(std::abs(r.deviations), std::abs(r.deviations_in_test));
}

}  // namespace

FitQuality quality_of(const Fit& f, std::size_t fits) {
  FitQuality q;
  q.statistic = f.chi2 + prior_rows(f);
  q.degrees_of_freedom =
      f.degrees_of_freedom + std::ranges::count_if(f.coefficients, &FittedCoefficient::at_bound);
  q.threshold = false_alarm / static_cast<double>(std::max<std::size_t>(1, fits));
  if (q.degrees_of_freedom > 0)
    q.p_value = gsl_cdf_chisq_Q(q.statistic, static_cast<double>(q.degrees_of_freedom));
  q.readings = readings_of(f);
  return q;
}

std::vector<FittedReading> worst_readings(const FitQuality& q, double limit, std::size_t most) {
  std::vector<FittedReading> worst;
  std::ranges::copy_if(q.readings, std::back_inserter(worst),
                       [&](const FittedReading& r) { return largest(r) > limit; });
  std::ranges::stable_sort(worst, std::greater{}, largest);
  if (worst.size() > most) worst.resize(most);
  return worst;
}

long readings_within(const FitQuality& q, double limit) {
  return std::ranges::count_if(
      q.readings, [&](const FittedReading& r) { return std::abs(r.deviations) <= limit; });
}

}  // namespace tdbd::calibration

#include "calibration/fit/robust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::calibration {
namespace {

/// The standardised errors of the readings with the deviations of `original`.
Eigen::VectorXd standardised(const Problem& original, const Eigen::VectorXd& errors) {
  return errors.cwiseQuotient(deviations(original));
}

/// The records with larger deviations of the readings that are far from the law.
std::vector<Record> reweighted(const CalibrationCase& c, const Problem& original,
                               const Eigen::VectorXd& errors) {
  std::vector<Record> records = original.records;
  const Eigen::VectorXd distance = standardised(original, errors).cwiseAbs();
  const Eigen::VectorXd whole = deviations(original);
  for (std::size_t i = 0; i < original.readings(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (distance[row] <= huber_limit) continue;
    Reading& reading = records[original.places[i].sample].readings[original.places[i].load];
    const double own = reading.deviation ? *reading.deviation / *reading.value : c.noise.reading;
    // The part that the reading shares with others is unchanged, so its own one contains the rest.
    const double more = whole[row] * whole[row] * (distance[row] / huber_limit - 1.0);
    reading.deviation = std::sqrt(own * own + more) * *reading.value;
  }
  return records;
}

/// Replaces the deviations of a fit by those of the original problem.
Fit with_original_deviations(Fit f, const Problem& original) {
  f.problem = original;
  const Eigen::VectorXd scaled = standardised(original, f.errors);
  f.objectives = {};
  for (std::size_t i = 0; i < original.readings(); ++i)
    f.objectives[original.places[i].load] += std::pow(scaled[static_cast<Eigen::Index>(i)], 2);
  Eigen::VectorXd whitened = f.errors;
  whiten(original, whitened);
  f.chi2 = whitened.squaredNorm();
  return f;
}

}  // namespace

Fit fit_with_loss(const CalibrationCase& c, const CutStore& cuts, const Problem& problem) {
  Fit f = fit(problem, c.intervals);
  if (c.loss == Loss::squares || c.unknowns.empty()) return f;
  for (int k = 0; k < most_reweightings; ++k) {
    const Eigen::VectorXd before = f.values;
    f = fit(problem_of(c, cuts, reweighted(c, problem, f.errors)), c.intervals);
    const Eigen::ArrayXd change = (f.values - before).array().abs();
    const Eigen::ArrayXd errors = f.covariance.diagonal().array().sqrt();
    if ((change <= settled_weights * errors).all())
      return with_original_deviations(std::move(f), problem);
  }
  throw RunError(
      fmt::format("the weights of the robust fit do not settle in {} fits: use "
                  "calibration.loss = \"squares\", or leave out the wrong rows",
                  most_reweightings));
}

}  // namespace tdbd::calibration

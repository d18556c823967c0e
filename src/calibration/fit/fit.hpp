#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "calibration/fit/solve.hpp"

namespace tdbd::calibration {

/// A fitted coefficient, SI.
struct FittedCoefficient {
  std::string key;
  double start = 0.0, value = 0.0;
  double se = 0.0;               ///< standard error; 0 at a bound
  double low = 0.0, high = 0.0;  ///< ends of the interval; equal to the value at a bound
  bool from_prior = false;       ///< the data determine little: see most_of_prior
  bool at_bound = false;         ///< no interval: the minimum is beyond the range
};

/// A coefficient is considered to come from its prior if its standard error is above this share of
/// the prior's.
inline constexpr double most_of_prior = 0.7;

/// A law fitted to records.
struct Fit {
  Problem problem;
  forces::Law law;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;  ///< of the values; zero rows for those at a bound
  std::vector<FittedCoefficient> coefficients;
  Loads objectives{};           ///< sum of (residual/deviation)^2 for each load
  Eigen::VectorXd errors;       ///< log(computed/measured) of the readings
  double chi2 = 0.0;            ///< of all whitened readings, without priors
  long degrees_of_freedom = 0;  ///< readings plus priors minus unknowns
  long evaluations = 0;
  std::vector<forces::Law> laws = {};  ///< for every mix of coefficients (AreaLaws)
};

/// Fits a problem. Throws RunError if the search converges from no start.
Fit fit(Problem problem, const Data& data, const Intervals& intervals);
Fit fit(const Problem& problem, const Intervals& intervals);

/// Relative standard deviation of each reading, from the diagonal of the covariance.
Eigen::VectorXd deviations(const Problem& problem);

/// The quantile z of the standard normal with P(|x| < z) = level.
double two_sided_quantile(double level);

}  // namespace tdbd::calibration

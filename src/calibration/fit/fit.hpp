#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "calibration/fit/solve.hpp"

namespace tdbd::calibration {

/// A fitted coefficient. SI.
struct FittedCoefficient {
  std::string key;
  double start = 0.0, value = 0.0;
  double se = 0.0;               ///< standard error; 0 at a bound
  double low = 0.0, high = 0.0;  ///< interval; the value at a bound
  bool from_prior = false;       ///< the data say little: see most_of_prior
  bool at_bound = false;         ///< no interval: the data would go beyond the range
};

/// A coefficient whose standard error is above this share of its prior's is the prior's.
inline constexpr double most_of_prior = 0.7;

/// A law fitted to records.
struct Fit {
  Problem problem;
  forces::Law law;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;  ///< of the values; rows of those at a bound are 0
  std::vector<FittedCoefficient> coefficients;
  Loads objectives{};           ///< sum of (residual/deviation)^2 of each load
  Eigen::VectorXd errors;       ///< log(computed/measured) of the readings
  double chi2 = 0.0;            ///< of all whitened readings, without priors
  long degrees_of_freedom = 0;  ///< readings and priors less unknowns
  long evaluations = 0;
  std::vector<forces::Law> laws = {};  ///< of every mix of coefficients (AreaLaws)
};

/// Fits a problem. Throws RunError when no start converges.
Fit fit(Problem problem, const Data& data, const Intervals& intervals);
Fit fit(const Problem& problem, const Intervals& intervals);

/// Deviation of each reading, relative, as its diagonal in the covariance has it.
Eigen::VectorXd deviations(const Problem& problem);

/// The quantile z of the standard normal with P(|x| < z) = level.
double two_sided_quantile(double level);

}  // namespace tdbd::calibration

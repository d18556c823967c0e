#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "calibration/fit/trust_region.hpp"

namespace tdbd::calibration {

/// Result of a search.
struct Solution {
  Eigen::VectorXd values;  ///< of the unknowns
  double chi2 = 0.0;       ///< sum of all squared rows
  bool converged = false;
  long evaluations = 0;  ///< number of evaluations of all residuals
  std::string reason;    ///< why it did not converge
};

/// Accuracy of a search. replicate: a small share of a standard error (trust_region.hpp); full:
/// then refined to ten digits (trust_region.hpp).
enum class Precision { full, replicate };

/// Least-squares search from these values. An unknown that is driven to an end of its range is
/// fixed there while the others are searched. The result is valid if the objective still decreases
/// beyond the end.
Solution solve(const Problem& problem, const Data& data, const Eigen::VectorXd& start,
               Precision precision = Precision::full);

/// Search from the starting values of the case. If it does not converge, up to `further_starts`
/// values drawn around them are tried. Throws RunError if none converges.
inline constexpr int further_starts = 20;
Solution solve_from_starts(const Problem& problem, const Data& data, std::uint64_t seed);

/// Draws values for another start: uniform in the inner half of a range with two ends, otherwise
/// within a factor of 2 of the starting value.
Eigen::VectorXd drawn_start(const Problem& problem, std::uint64_t seed);

/// A fitted coefficient, SI.
struct FittedCoefficient {
  std::string key;
  double start = 0.0, value = 0.0;
  double se = 0.0;               ///< standard error; 0 at a bound
  double low = 0.0, high = 0.0;  ///< ends of the interval; equal to the value at a bound
  bool from_prior = false;       ///< the data determine little: see prior_dominance
  bool at_bound = false;         ///< no interval: the minimum is beyond the range
};

/// A coefficient is considered to come from its prior if its standard error is above this share of
/// the prior's.
inline constexpr double prior_dominance = 0.7;

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

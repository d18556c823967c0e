#pragma once

#include <Eigen/Dense>
#include <string>

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
/// then refined to ten digits (polish.hpp).
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

}  // namespace tdbd::calibration

#pragma once

#include <Eigen/Dense>
#include <string>

#include "calibration/fit/trust_region.hpp"

namespace tdbd::calibration {

/// Where a search ended.
struct Solution {
  Eigen::VectorXd values;  ///< of the unknowns
  double chi2 = 0.0;       ///< sum of all squared rows
  bool converged = false;
  long evaluations = 0;  ///< of all residuals
  std::string reason;    ///< why it did not converge
};

/// How far a search goes. replicate: to a small share of a standard error (trust_region.hpp); full:
/// on from there to ten digits (polish.hpp).
enum class Precision { full, replicate };

/// Least squares from these values. An unknown that is driven to an end of its range stays there
/// while the others are searched; the result counts if the objective still falls beyond.
Solution solve(const Problem& problem, const Data& data, const Eigen::VectorXd& start,
               Precision precision = Precision::full);

/// From the starts of the case; where that does not converge, from up to `further_starts` values
/// drawn around them. Throws RunError when none converges.
inline constexpr int further_starts = 20;
Solution solve_from_starts(const Problem& problem, const Data& data, std::uint64_t seed);

/// Values drawn for another start: uniform in the inner half of a range with two ends, within a
/// factor of 2 of the start elsewhere.
Eigen::VectorXd drawn_start(const Problem& problem, std::uint64_t seed);

}  // namespace tdbd::calibration

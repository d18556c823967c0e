#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::reference {

/// What the error of one reading is made of, relative.
struct ReadingError {
  std::string test;    ///< a factor is common to it
  long record = 0;     ///< the rate's error is common to it
  double own = 0.0;    ///< standard deviation
  double slope = 0.0;  ///< d log load / d log rate
};

/// Deviations that readings share.
struct SharedError {
  double test = 0.0, rate = 0.0;
};

/// The covariance of all readings in one matrix, pair by pair.
Eigen::MatrixXd covariance_of_readings(const std::vector<ReadingError>& readings,
                                       const SharedError& shared);

/// The inverse by Gauss and Jordan with pivots.
Eigen::MatrixXd inverse_by_elimination(Eigen::MatrixXd A);

/// Deviations of priors, none where there is none.
using Priors = std::vector<std::optional<double>>;

/// (J^T C^-1 J + P)^-1: the covariance of coefficients from derivatives J of the logarithms of the
/// readings, their covariance C, and 1/deviation^2 of the priors in P.
Eigen::MatrixXd covariance_of_coefficients(const Eigen::MatrixXd& J, const Eigen::MatrixXd& C,
                                           const Priors& priors);

}  // namespace tdbd::reference

#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::reference {

/// Components of the relative error of one reading.
struct ReadingError {
  std::string test;    ///< readings of one test share a factor
  long record = 0;     ///< readings of one record share the error of the rate
  double own = 0.0;    ///< standard deviation
  double slope = 0.0;  ///< d log load / d log rate
};

/// Standard deviations of errors that readings share.
struct SharedError {
  double test = 0.0, rate = 0.0;
};

/// The covariance of all readings in one matrix, pair by pair.
Eigen::MatrixXd covariance_of_readings(const std::vector<ReadingError>& readings,
                                       const SharedError& shared);

/// The inverse by Gauss-Jordan elimination with pivoting.
Eigen::MatrixXd inverse_by_elimination(Eigen::MatrixXd A);

/// Standard deviations of priors; empty where there is no prior.
using Priors = std::vector<std::optional<double>>;

/// (J^T C^-1 J + P)^-1: the covariance of coefficients. J: derivatives of the logarithms of the
/// readings; C: their covariance; P: 1/deviation^2 of the priors.
Eigen::MatrixXd covariance_of_coefficients(const Eigen::MatrixXd& J, const Eigen::MatrixXd& C,
                                           const Priors& priors);

}  // namespace tdbd::reference

#pragma once

#include <Eigen/Dense>

namespace tdbd::reference {

/// Returns x >= 0 that minimizes |A x - b|, by the active-set method of Lawson and Hanson (1974),
/// chapter 23. Each set is solved by dense normal equations. For few columns.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace tdbd::reference

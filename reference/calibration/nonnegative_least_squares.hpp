#pragma once

#include <Eigen/Dense>

namespace tdbd::reference {

/// x >= 0 that makes |A x - b| least: the active sets of Lawson and Hanson (1974), chapter 23, each
/// solved by dense normal equations. For few columns.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace tdbd::reference

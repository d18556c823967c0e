#pragma once

#include <Eigen/Core>
#include <functional>

namespace tdbd::reference {

/// Finds the velocity u = free + A f(u) by integrating du/dtau = free + A f(u) - u in small steps
/// of tau to a steady state. Slow, and independent of the form of f. `steepness`: a bound of |A
/// f'|. `from`: initial value, because there may be several solutions. Throws RunError if it does
/// not converge to 1e-12 of `free` within a million steps.
Eigen::VectorXd relaxed_velocity(const Eigen::VectorXd& free, const Eigen::MatrixXd& A,
                                 const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f,
                                 double steepness, Eigen::VectorXd from);

}  // namespace tdbd::reference

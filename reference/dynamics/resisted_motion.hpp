#pragma once

#include <Eigen/Core>
#include <functional>

namespace tdbd::reference {

/// The velocity u = free + A f(u) by following du/dtau = free + A f(u) - u in small steps of tau
/// until it rests: slow, and blind to what f is made of. `steepness`: a bound of |A f'|; `from`: where to begin,
/// as there may be several. Throws RunError if it does not rest to 1e-12 of `free` within a million steps.
Eigen::VectorXd relaxed_velocity(const Eigen::VectorXd& free, const Eigen::MatrixXd& A,
                                 const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f,
                                 double steepness, Eigen::VectorXd from);

}  // namespace tdbd::reference

#include "reference/dynamics/resisted_motion.hpp"

#include <utility>

#include "core/error.hpp"

namespace tdbd::reference {

Eigen::VectorXd relaxed_velocity(const Eigen::VectorXd& free, const Eigen::MatrixXd& A,
                                 const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f,
                                 double steepness, Eigen::VectorXd from) {
  constexpr long most_steps = 1'000'000;
  const double step = 0.5 / (1.0 + steepness);
  Eigen::VectorXd u = std::move(from);
  for (long i = 0; i < most_steps; ++i) {
    const Eigen::VectorXd rest = free + A * f(u) - u;
    if (rest.norm() <= 1e-12 * free.norm()) return u;
    u += step * rest;
  }
  throw RunError("the velocity does not come to rest");
}

}  // namespace tdbd::reference

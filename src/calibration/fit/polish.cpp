#include "calibration/fit/polish.hpp"

#include "calibration/fit/bounded_map.hpp"

namespace tdbd::calibration {
namespace {

/// Residuals where the free unknowns have these free variables.
Eigen::VectorXd residuals_of(Search& s, const Eigen::VectorXd& u) {
  ++s.evaluations;
  Eigen::VectorXd values = s.values;
  for (std::size_t i = 0; i < s.free.size(); ++i)
    values[s.free[i]] = value_of(s.unknown(i).range, u[static_cast<Eigen::Index>(i)]);
  return residuals_at(s.problem, s.data, values);
}

/// Differences of fourth order in a wide step: a narrow one loses what is sought.
Eigen::MatrixXd wide_derivatives(Search& s, const Eigen::VectorXd& u) {
  constexpr double h = 1e-3;
  Eigen::MatrixXd J(s.problem.rows(), u.size());
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(u.size(), k);
    J.col(k) = (8.0 * (residuals_of(s, u + step) - residuals_of(s, u - step)) -
                (residuals_of(s, u + 2.0 * step) - residuals_of(s, u - 2.0 * step))) /
               (12.0 * h);
  }
  return J;
}

}  // namespace

void polish(Search& s) {
  constexpr int steps = 2;
  constexpr double most = 1e-5;
  if (s.free.empty()) return;
  Eigen::VectorXd u(static_cast<Eigen::Index>(s.free.size()));
  for (std::size_t i = 0; i < s.free.size(); ++i)
    u[static_cast<Eigen::Index>(i)] = free_variable(s.unknown(i).range, s.values[s.free[i]]);
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd step =
        wide_derivatives(s, u).colPivHouseholderQr().solve(-residuals_of(s, u));
    if (!(step.cwiseAbs().maxCoeff() < most)) return;
    u += step;
    for (std::size_t k = 0; k < s.free.size(); ++k)
      s.values[s.free[k]] = value_of(s.unknown(k).range, u[static_cast<Eigen::Index>(k)]);
  }
}

}  // namespace tdbd::calibration

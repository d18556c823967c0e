#include "calibration/fit/polish.hpp"

#include "calibration/fit/bounded_map.hpp"

namespace tdbd::calibration {
namespace {

/// Derivatives with respect to the free variables u of the free unknowns: fourth-order differences
/// with a wide step, because a small step would lose the required digits.
Eigen::MatrixXd wide_derivatives(Search& s, const Eigen::VectorXd& u) {
  constexpr double h = 1e-3;
  constexpr int evaluations = 4;
  OneMoves moves(s.problem, s.values);
  Eigen::MatrixXd J(s.problem.rows(), u.size());
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto at = [&](double step) {
      return moves.residuals(s.free[i], value_of(s.unknown(i).range, u[k] + step));
    };
    J.col(k) = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
  }
  s.evaluations += evaluations * u.size();
  return J;
}

}  // namespace

void polish(Search& s) {
  constexpr int steps = 6;
  constexpr double most = 1e-3, least = 1e-9;
  if (s.free.empty()) return;
  Eigen::VectorXd u(static_cast<Eigen::Index>(s.free.size()));
  for (std::size_t i = 0; i < s.free.size(); ++i)
    u[static_cast<Eigen::Index>(i)] = free_variable(s.unknown(i).range, s.values[s.free[i]]);
  bool last = false;
  for (int i = 0; i < steps && !last; ++i) {
    const Eigen::VectorXd rows = residuals_at(s.problem, s.data, s.values);
    const Eigen::VectorXd step = wide_derivatives(s, u).colPivHouseholderQr().solve(-rows);
    if (!(step.cwiseAbs().maxCoeff() < most)) return;
    u += step;
    last = step.cwiseAbs().maxCoeff() < least;
    for (std::size_t k = 0; k < s.free.size(); ++k)
      s.values[s.free[k]] = value_of(s.unknown(k).range, u[static_cast<Eigen::Index>(k)]);
  }
}

}  // namespace tdbd::calibration

#include "reference/calibration/variable_projection.hpp"

#include <cmath>
#include <functional>

#include "reference/calibration/dense_covariance.hpp"
#include "reference/calibration/nonnegative_least_squares.hpp"

namespace tdbd::reference {
namespace {

/// The parts of the problem that do not change in a search.
struct Setup {
  const Readings& readings;
  const SevenPriors& priors;
  Eigen::MatrixXd whitener;  ///< S with S^T S = C^-1
};

std::array<double, 7> in_order(const Coefficients& c) {
  return {c.A1, c.A2, c.A3, c.A4, c.A5, c.A6, c.pressure_share};
}

Eigen::MatrixXd unit_rows(const Readings& r, const Coefficients& c) {
  std::vector<UnitLoads> units;
  for (const auto& cuts : r.records) units.push_back(unit_loads(cuts, c));
  Eigen::MatrixXd M(static_cast<Eigen::Index>(r.places.size()), factors);
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    const auto& [record, load] = r.places[static_cast<std::size_t>(i)];
    M.row(i) = units[record].row(load);
  }
  return M;
}

/// All rows: whitened logarithms, then the priors.
Eigen::VectorXd rows_at(const Setup& s, const Eigen::MatrixXd& M, const Coefficients& c) {
  const Eigen::VectorXd loads = M * factors_of(c), logs = loads.array().log();
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(logs.size() + 7);
  rows.head(logs.size()) = s.whitener * (logs - s.readings.log_loads);
  const std::array<double, 7> values = in_order(c);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (const Prior& p = s.priors[k]; p.sd)
      rows[logs.size() + static_cast<Eigen::Index>(k)] = (values[k] - p.centre) / *p.sd;
  return rows;
}

/// Derivatives of the rows with respect to the factors: A2 = x1/x0, A6 = x4/x3.
Eigen::MatrixXd slopes_at(const Setup& s, const Eigen::MatrixXd& M, const Coefficients& c) {
  const Factors x = factors_of(c);
  const Eigen::Index n = M.rows();
  const Eigen::VectorXd loads = M * x;
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n + 7, factors);
  D.topRows(n) = s.whitener * loads.cwiseInverse().asDiagonal() * M;
  const auto prior = [&](Eigen::Index k) {
    const auto& sd = s.priors[static_cast<std::size_t>(k)].sd;
    return sd ? 1.0 / *sd : 0.0;
  };
  D(n, 0) = prior(0);
  D(n + 1, 0) = -prior(1) * x[1] / (x[0] * x[0]);
  D(n + 1, 1) = prior(1) / x[0];
  D(n + 3, 2) = prior(3);
  D(n + 4, 3) = prior(4);
  if (x[3] > 0.0) {
    D(n + 5, 3) = -prior(5) * x[4] / (x[3] * x[3]);
    D(n + 5, 4) = prior(5) / x[3];
  }
  return D;
}

/// The best factors for these A3 and pressure_share.
Projected best_factors(const Setup& s, Coefficients c) {
  const Eigen::MatrixXd M = unit_rows(s.readings, c);
  Eigen::VectorXd rows = rows_at(s, M, c);
  double least = rows.squaredNorm();
  constexpr int most = 200;
  for (int i = 0; i < most; ++i) {
    const Factors x = factors_of(c);
    const Eigen::MatrixXd D = slopes_at(s, M, c);
    const Factors towards = nonnegative_least_squares(D, D * x - rows);
    const double before = least;
    for (double share = 1.0; share > 1e-6; share *= 0.5) {
      const Coefficients tried = with_factors(c, x + share * (towards - x));
      const Eigen::VectorXd there = rows_at(s, M, tried);
      if (!(there.squaredNorm() < least)) continue;
      c = tried;
      rows = there;
      least = there.squaredNorm();
      break;
    }
    if (before - least <= 1e-14 * before) break;
  }
  return {c, least};
}

/// Golden-section search between a and b for the minimum of f(x).objective.
Projected golden(const std::function<Projected(double)>& f, double a, double b, int sections) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double left = b - ratio * (b - a), right = a + ratio * (b - a);
  Projected at_left = f(left), at_right = f(right);
  for (int i = 0; i < sections; ++i) {
    if (at_left.objective < at_right.objective) {
      b = right;
      right = left;
      at_right = at_left;
      left = b - ratio * (b - a);
      at_left = f(left);
    } else {
      a = left;
      left = right;
      at_left = at_right;
      right = a + ratio * (b - a);
      at_right = f(right);
    }
  }
  return at_left.objective < at_right.objective ? at_left : at_right;
}

Coefficients at_place(Coefficients c, double A3, double share) {
  c.A3 = A3;
  c.pressure_share = share;
  return c;
}

}  // namespace

Projected variable_projection(const Readings& readings, const Coefficients& start,
                              const SearchRange& range, const SevenPriors& priors) {
  const Setup setup{readings, priors, inverse_by_elimination(readings.covariance).llt().matrixU()};
  constexpr int cells = 8, sections = 40;
  const double dA3 = (range.A3_hi - range.A3_lo) / cells;
  const double dshare = (range.share_hi - range.share_lo) / cells;
  Projected best{start, std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const Projected p =
          best_factors(setup, at_place(start, range.A3_lo + i * dA3, range.share_lo + j * dshare));
      if (p.objective < best.objective) best = p;
    }
  const auto ends = [](double x, double d, double lo, double hi) {
    return std::pair{std::max(lo, x - d), std::min(hi, x + d)};
  };
  const auto [a, b] = ends(best.coefficients.A3, dA3, range.A3_lo, range.A3_hi);
  const auto over_share = [&](double A3) {
    return golden(
        [&](double share) { return best_factors(setup, at_place(best.coefficients, A3, share)); },
        range.share_lo, range.share_hi, sections);
  };
  return golden(over_share, a, b, sections);
}

}  // namespace tdbd::reference

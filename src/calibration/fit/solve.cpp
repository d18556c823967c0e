#include "calibration/fit/solve.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>
#include <vector>

#include "calibration/fit/bounded_map.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace tdbd::calibration {
namespace {

/// What GSL hands back to the residuals.
struct Search {
  const Problem& problem;
  const Data& data;
  long evaluations = 0;
};

Eigen::VectorXd values_of(const Problem& p, const gsl_vector* u) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(u->size));
  for (std::size_t k = 0; k < u->size; ++k)
    values[static_cast<Eigen::Index>(k)] = value_of(p.unknowns[k].range, gsl_vector_get(u, k));
  return values;
}

int residuals(const gsl_vector* u, void* search, gsl_vector* f) {
  auto& s = *static_cast<Search*>(search);
  ++s.evaluations;
  const Eigen::VectorXd r = residuals_at(s.problem, s.data, values_of(s.problem, u));
  if (!r.allFinite()) return GSL_EDOM;
  for (Eigen::Index i = 0; i < r.size(); ++i) gsl_vector_set(f, static_cast<std::size_t>(i), r[i]);
  return GSL_SUCCESS;
}

struct FreeWorkspace {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
struct FreeVector {
  void operator()(gsl_vector* v) const { gsl_vector_free(v); }
};

gsl_multifit_nlinear_parameters parameters(Precision precision) {
  gsl_multifit_nlinear_parameters p = gsl_multifit_nlinear_default_parameters();
  p.trs = gsl_multifit_nlinear_trs_ddogleg;
  p.solver = gsl_multifit_nlinear_solver_svd;
  p.fdtype =
      precision == Precision::full ? GSL_MULTIFIT_NLINEAR_CTRDIFF : GSL_MULTIFIT_NLINEAR_FWDIFF;
  constexpr double step = 1e-6;
  p.h_df = step;
  return p;
}

/// Not moving any more is converged; so is a search that cannot go lower from where the gradient
/// is rounding.
bool is_converged(int status, int info, gsl_multifit_nlinear_workspace* w) {
  if (status == GSL_SUCCESS) return info == 1 || info == 2;
  if (status != GSL_ENOPROG) return false;
  constexpr double rounding = 1e-5;
  double largest = 0.0, norm = 0.0;
  const gsl_vector* f = gsl_multifit_nlinear_residual(w);
  for (std::size_t i = 0; i < f->size; ++i) norm += std::pow(gsl_vector_get(f, i), 2);
  for (std::size_t k = 0; k < w->g->size; ++k)
    largest = std::max(largest, std::abs(gsl_vector_get(w->g, k)));
  return largest <= rounding * std::max(1.0, norm);
}

/// Where a search goes on by gradients: its free variables and those that are not at a bound.
struct Polish {
  Search& search;
  std::vector<Eigen::Index> free;

  Eigen::VectorXd residuals_of(const Eigen::VectorXd& u) const {
    ++search.evaluations;
    Eigen::VectorXd values(u.size());
    for (Eigen::Index k = 0; k < u.size(); ++k)
      values[k] = value_of(search.problem.unknowns[static_cast<std::size_t>(k)].range, u[k]);
    return residuals_at(search.problem, search.data, values);
  }

  /// Differences of fourth order in a wide step: a narrow one loses what is sought.
  Eigen::MatrixXd derivatives(const Eigen::VectorXd& u) const {
    constexpr double h = 1e-3;
    Eigen::MatrixXd J(search.problem.rows(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(u.size(), free[i]);
      J.col(static_cast<Eigen::Index>(i)) =
          (8.0 * (residuals_of(u + step) - residuals_of(u - step)) -
           (residuals_of(u + 2.0 * step) - residuals_of(u - 2.0 * step))) /
          (12.0 * h);
    }
    return J;
  }
};

/// A search that goes by the sum of squares cannot tell values nearer than the root of rounding:
/// the order of records would show in the eighth digit. Steps of Gauss and Newton go on from there.
/// They are small, or the readings do not see what they change: then they are left.
void polish(const Polish& p, Eigen::VectorXd& values) {
  constexpr int steps = 2;
  constexpr double most = 1e-5;
  Eigen::VectorXd u(values.size());
  for (Eigen::Index k = 0; k < u.size(); ++k)
    u[k] = free_variable(p.search.problem.unknowns[static_cast<std::size_t>(k)].range, values[k]);
  for (int i = 0; i < steps && !p.free.empty(); ++i) {
    const Eigen::VectorXd step = p.derivatives(u).colPivHouseholderQr().solve(-p.residuals_of(u));
    if (!(step.cwiseAbs().maxCoeff() < most)) return;
    u(p.free) += step;
    for (const Eigen::Index k : p.free)
      values[k] = value_of(p.search.problem.unknowns[static_cast<std::size_t>(k)].range, u[k]);
  }
}

}  // namespace

std::vector<Eigen::Index> off_bounds(const Problem& p, const Eigen::VectorXd& values) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const Unknown& u = p.unknowns[static_cast<std::size_t>(k)];
    if (!is_at_bound(u.range, values[k], u.start)) free.push_back(k);
  }
  return free;
}

Solution solve(const Problem& p, const Data& data, const Eigen::VectorXd& start,
               Precision precision) {
  const double tolerance = precision == Precision::full ? 1e-11 : 1e-6;
  gsl_set_error_handler_off();
  Search search{p, data};
  const std::size_t n = static_cast<std::size_t>(p.rows()), k = p.unknowns.size();
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals;
  fdf.n = n;
  fdf.p = k;
  fdf.params = &search;
  const auto options = parameters(precision);
  const std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace> w(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, n, k));
  const std::unique_ptr<gsl_vector, FreeVector> u(gsl_vector_alloc(k));
  for (std::size_t i = 0; i < k; ++i)
    gsl_vector_set(u.get(), i,
                   free_variable(p.unknowns[i].range, start[static_cast<Eigen::Index>(i)]));
  int info = 0;
  int status = gsl_multifit_nlinear_init(u.get(), &fdf, w.get());
  if (status == GSL_SUCCESS)
    status = gsl_multifit_nlinear_driver(most_iterations, tolerance, tolerance, 0.0, nullptr,
                                         nullptr, &info, w.get());
  Solution s;
  s.values = values_of(p, gsl_multifit_nlinear_position(w.get()));
  if (precision == Precision::full && is_converged(status, info, w.get()))
    polish({search, off_bounds(p, s.values)}, s.values);
  s.chi2 = residuals_at(p, data, s.values).squaredNorm();
  s.evaluations = search.evaluations;
  s.converged = std::isfinite(s.chi2) && is_converged(status, info, w.get());
  if (!s.converged) s.reason = gsl_strerror(status);
  return s;
}

Eigen::VectorXd drawn_start(const Problem& p, std::uint64_t seed) {
  Random random{seed};
  Eigen::VectorXd values(static_cast<Eigen::Index>(p.unknowns.size()));
  for (std::size_t k = 0; k < p.unknowns.size(); ++k) {
    const Unknown& u = p.unknowns[k];
    const bool two_ends = std::isfinite(u.range.lo) && std::isfinite(u.range.hi);
    const double width = u.range.hi - u.range.lo;
    values[static_cast<Eigen::Index>(k)] = two_ends
                                               ? u.range.lo + width * random.uniform(0.25, 0.75)
                                               : u.start * std::exp2(random.uniform(-1.0, 1.0));
  }
  return values;
}

Solution solve_from_starts(const Problem& p, const Data& data, std::uint64_t seed) {
  Eigen::VectorXd start(static_cast<Eigen::Index>(p.unknowns.size()));
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    start[static_cast<Eigen::Index>(k)] = p.unknowns[k].start;
  std::string reason;
  for (int attempt = 0; attempt <= further_starts; ++attempt) {
    const Solution s = solve(p, data, start);
    if (s.converged) return s;
    if (attempt == 0) reason = s.reason;
    start = drawn_start(p, seed + static_cast<std::uint64_t>(attempt));
  }
  throw RunError(fmt::format("the fit converges from none of {} starts; from the case's: {}",
                             further_starts + 1, reason));
}

}  // namespace tdbd::calibration

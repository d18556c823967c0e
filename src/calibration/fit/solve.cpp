#include "calibration/fit/solve.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>

#include "calibration/fit/bounded_map.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace tdbd::calibration {
namespace {

/// What GSL hands back to the residuals.
struct Search {
  const Problem& problem;
  const Data& data;
  Difference difference = Difference::central;
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

/// GSL's own differences scale their steps by |u|, which has no meaning here and may be 0.
int derivatives(const gsl_vector* u, void* search, gsl_matrix* J) {
  auto& s = *static_cast<Search*>(search);
  const Eigen::VectorXd values = values_of(s.problem, u);
  const Eigen::MatrixXd by_values = jacobian_at(s.problem, values, s.difference);
  s.evaluations += (s.difference == Difference::central ? 2 : 1) * values.size();
  if (!by_values.allFinite()) return GSL_EDOM;
  for (std::size_t i = 0; i < J->size1; ++i)
    for (std::size_t k = 0; k < J->size2; ++k) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(k);
      gsl_matrix_set(
          J, i, k, by_values(row, column) * slope_at(s.problem.unknowns[k].range, values[column]));
    }
  return GSL_SUCCESS;
}

struct FreeWorkspace {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
struct FreeVector {
  void operator()(gsl_vector* v) const { gsl_vector_free(v); }
};

gsl_multifit_nlinear_parameters parameters() {
  gsl_multifit_nlinear_parameters p = gsl_multifit_nlinear_default_parameters();
  p.trs = gsl_multifit_nlinear_trs_ddogleg;
  p.solver = gsl_multifit_nlinear_solver_svd;
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

Solution search_from(const Problem& p, const Data& data, const Eigen::VectorXd& start,
                     Precision precision) {
  const double tolerance = precision == Precision::full ? 1e-7 : 1e-5;
  gsl_set_error_handler_off();
  Search search{p, data,
                precision == Precision::full ? Difference::central : Difference::one_sided};
  const std::size_t n = static_cast<std::size_t>(p.rows()), k = p.unknowns.size();
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals;
  fdf.df = derivatives;
  fdf.n = n;
  fdf.p = k;
  fdf.params = &search;
  const auto options = parameters();
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
  const bool converged = is_converged(status, info, w.get());
  if (converged && precision == Precision::full) gsl_multifit_nlinear_iterate(w.get());
  Solution s;
  s.values = values_of(p, gsl_multifit_nlinear_position(w.get()));
  s.chi2 = residuals_at(p, data, s.values).squaredNorm();
  s.evaluations = search.evaluations;
  s.converged = std::isfinite(s.chi2) && converged;
  if (!s.converged) s.reason = gsl_strerror(status);
  return s;
}

}  // namespace

Solution solve(const Problem& p, const Data& data, const Eigen::VectorXd& start,
               Precision precision) {
  Solution rough = search_from(p, data, start, Precision::replicate);
  if (precision == Precision::replicate) return rough;
  Solution s = search_from(p, data, rough.values, Precision::full);
  s.evaluations += rough.evaluations;
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

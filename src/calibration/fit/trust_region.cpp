#include "calibration/fit/trust_region.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace tdbd::calibration {
namespace {

/// A Range with an upper end also has a lower one: laws have no other coefficients.
bool has_both_ends(const Range& r) { return std::isfinite(r.lo) && std::isfinite(r.hi); }

}  // namespace

double value_of(const Range& r, double u) {
  if (has_both_ends(r)) return r.lo + (r.hi - r.lo) / (1.0 + std::exp(-u));
  return std::isfinite(r.lo) ? r.lo + std::exp(u) : u;
}

double free_variable(const Range& r, double value) {
  if (has_both_ends(r)) return std::log((value - r.lo) / (r.hi - value));
  return std::isfinite(r.lo) ? std::log(value - r.lo) : value;
}

double slope_at(const Range& r, double value) {
  if (has_both_ends(r)) return (value - r.lo) * (r.hi - value) / (r.hi - r.lo);
  return std::isfinite(r.lo) ? value - r.lo : 1.0;
}

bool is_at_bound(const Range& r, double value, double start) {
  if (has_both_ends(r))
    return std::min(value - r.lo, r.hi - value) < at_bound_share * (r.hi - r.lo);
  return std::isfinite(r.lo) && value - r.lo < at_bound_share * (start - r.lo);
}

namespace {

Eigen::VectorXd values_of(const Search& s, const gsl_vector* u) {
  Eigen::VectorXd values = s.values;
  for (std::size_t i = 0; i < u->size; ++i)
    values[s.free[i]] = value_of(s.unknown(i).range, gsl_vector_get(u, i));
  return values;
}

int residuals(const gsl_vector* u, void* search, gsl_vector* f) {
  auto& s = *static_cast<Search*>(search);
  ++s.evaluations;
  const Eigen::VectorXd r = residuals_at(s.problem, s.data, values_of(s, u));
  if (!r.allFinite()) return GSL_EDOM;
  for (Eigen::Index i = 0; i < r.size(); ++i) gsl_vector_set(f, static_cast<std::size_t>(i), r[i]);
  return GSL_SUCCESS;
}

/// Derivatives by jacobian_at and the chain rule. The differences of GSL are not used: their steps
/// scale with |u|, which has no meaning here and may be 0.
int derivatives(const gsl_vector* u, void* search, gsl_matrix* J) {
  auto& s = *static_cast<Search*>(search);
  const Eigen::VectorXd values = values_of(s, u);
  const Eigen::MatrixXd by_values = jacobian_at(s.problem, values, Difference::one_sided);
  s.evaluations += values.size() + 1;
  if (!by_values.allFinite()) return GSL_EDOM;
  for (std::size_t i = 0; i < J->size1; ++i)
    for (std::size_t k = 0; k < J->size2; ++k)
      gsl_matrix_set(J, i, k,
                     by_values(static_cast<Eigen::Index>(i), s.free[k]) *
                         slope_at(s.unknown(k).range, values[s.free[k]]));
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

/// Whether the gradient is at rounding level. A search that makes no progress from there has
/// converged.
bool is_flat(gsl_multifit_nlinear_workspace* w) {
  constexpr double rounding = 1e-5;
  double largest = 0.0, norm = 0.0;
  const gsl_vector* f = gsl_multifit_nlinear_residual(w);
  for (std::size_t i = 0; i < f->size; ++i) norm += std::pow(gsl_vector_get(f, i), 2);
  for (std::size_t k = 0; k < w->g->size; ++k)
    largest = std::max(largest, std::abs(gsl_vector_get(w->g, k)));
  return largest <= rounding * std::max(1.0, norm);
}

/// Whether an unknown is driven out. It would use the whole trust region, because u is unbounded.
bool drives_one_out(const Search& s, const gsl_multifit_nlinear_workspace* w) {
  const Eigen::VectorXd values = values_of(s, w->x);
  for (std::size_t i = 0; i < s.free.size(); ++i)
    if (is_driven_out_of_range(s.unknown(i), values[s.free[i]], gsl_vector_get(w->g, i)))
      return true;
  return false;
}

/// Like the driver of GSL, but also stops if an unknown is driven out (GSL_CONTINUE).
int iterate(const Search& s, double tolerance, gsl_multifit_nlinear_workspace* w) {
  int status = GSL_CONTINUE, info = 0;
  for (int i = 0; i < most_iterations; ++i) {
    status = gsl_multifit_nlinear_iterate(w);
    if (status == GSL_ENOPROG && i == 0) break;
    if (status != GSL_SUCCESS && status != GSL_ENOPROG) return status;
    if (drives_one_out(s, w)) return GSL_CONTINUE;
    status = gsl_multifit_nlinear_test(tolerance, tolerance, 0.0, &info, w);
    if (status == GSL_SUCCESS) return status;
  }
  if (is_flat(w)) return GSL_SUCCESS;
  return status == GSL_CONTINUE ? GSL_EMAXITER : status;
}

bool is_nearer_to_lower_end(const Range& r, double value) {
  return !(std::isfinite(r.hi) && r.hi - value < value - r.lo);
}

}  // namespace

bool is_driven_out_of_range(const Unknown& u, double value, double gradient) {
  if (!is_at_bound(u.range, value, u.start)) return false;
  return is_nearer_to_lower_end(u.range, value) ? gradient >= 0.0 : gradient <= 0.0;
}

double end_width(const Unknown& u) {
  return at_bound_share * ((std::isfinite(u.range.hi) ? u.range.hi : u.start) - u.range.lo);
}

namespace {

/// The value at `widths` end widths inside of the end that the value is at.
double near_end_of_range(const Unknown& u, double value, double widths) {
  const double margin = widths * end_width(u);
  return is_nearer_to_lower_end(u.range, value) ? u.range.lo + margin : u.range.hi - margin;
}

}  // namespace

double end_of(const Unknown& u, double value) { return near_end_of_range(u, value, 1e-5); }

double inside_of(const Unknown& u, double value) { return near_end_of_range(u, value, 10.0); }

int search_from_values(Search& search) {
  constexpr double tolerance = 1e-5;
  if (search.free.empty()) return GSL_SUCCESS;
  const auto n = static_cast<std::size_t>(search.problem.rows()), k = search.free.size();
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
                   free_variable(search.unknown(i).range, search.values[search.free[i]]));
  int status = gsl_multifit_nlinear_init(u.get(), &fdf, w.get());
  if (status == GSL_SUCCESS) status = iterate(search, tolerance, w.get());
  search.values = values_of(search, gsl_multifit_nlinear_position(w.get()));
  return status;
}

namespace {

/// Derivatives with respect to the free variables u of the free unknowns: fourth-order differences
/// with a wide step, because a small step would lose the required digits.
Eigen::MatrixXd wide_derivatives(Search& s, const Eigen::VectorXd& u) {
  constexpr double h = 1e-3;
  constexpr int evaluations = 4;
  SingleChange moves(s.problem, s.values);
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

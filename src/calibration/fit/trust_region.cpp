#include "calibration/fit/trust_region.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "calibration/fit/bounded_map.hpp"

namespace tdbd::calibration {
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
    if (is_driven_out(s.unknown(i), values[s.free[i]], gsl_vector_get(w->g, i))) return true;
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

bool is_driven_out(const Unknown& u, double value, double gradient) {
  if (!is_at_bound(u.range, value, u.start)) return false;
  return is_nearer_to_lower_end(u.range, value) ? gradient >= 0.0 : gradient <= 0.0;
}

double end_width(const Unknown& u) {
  return at_bound_share * ((std::isfinite(u.range.hi) ? u.range.hi : u.start) - u.range.lo);
}

namespace {

/// The value at `widths` end widths inside of the end that the value is at.
double beside_end(const Unknown& u, double value, double widths) {
  const double room = widths * end_width(u);
  return is_nearer_to_lower_end(u.range, value) ? u.range.lo + room : u.range.hi - room;
}

}  // namespace

double end_of(const Unknown& u, double value) { return beside_end(u, value, 1e-5); }

double inside_of(const Unknown& u, double value) { return beside_end(u, value, 10.0); }

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

}  // namespace tdbd::calibration

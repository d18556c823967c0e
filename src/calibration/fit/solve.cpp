#include "calibration/fit/solve.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "calibration/fit/bounded_map.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace tdbd::calibration {
namespace {

/// What GSL hands back to the residuals: a search moves the unknowns `free`, the others stay.
struct Search {
  const Problem& problem;
  const Data& data;
  Difference difference = Difference::central;
  Eigen::VectorXd values;
  std::vector<Eigen::Index> free;
  long evaluations = 0;

  const Unknown& unknown(std::size_t i) const {
    return problem.unknowns[static_cast<std::size_t>(free[i])];
  }
};

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

/// GSL's own differences scale their steps by |u|, which has no meaning here and may be 0.
int derivatives(const gsl_vector* u, void* search, gsl_matrix* J) {
  auto& s = *static_cast<Search*>(search);
  const Eigen::VectorXd values = values_of(s, u);
  const Eigen::MatrixXd by_values = jacobian_at(s.problem, values, s.difference);
  s.evaluations += (s.difference == Difference::central ? 2 : 1) * values.size();
  if (!by_values.allFinite()) return GSL_EDOM;
  for (std::size_t i = 0; i < J->size1; ++i)
    for (std::size_t k = 0; k < J->size2; ++k)
      gsl_matrix_set(J, i, k,
                     by_values(static_cast<Eigen::Index>(i), s.free[k]) *
                         slope_at(s.unknown(k).range, values[s.free[k]]));
  return GSL_SUCCESS;
}

bool is_nearer_to_lower_end(const Range& r, double value) {
  return !(std::isfinite(r.hi) && r.hi - value < value - r.lo);
}

/// Whether a value is on an end of its range and the objective falls beyond it.
bool is_driven_out(const Unknown& u, double value, double gradient) {
  if (!is_at_bound(u.range, value, u.start)) return false;
  return is_nearer_to_lower_end(u.range, value) ? gradient >= 0.0 : gradient <= 0.0;
}

/// Where a coefficient stays that is driven out: at its end, but for the room of a difference.
double end_of(const Unknown& u, double value) {
  constexpr double share = 1e-6 * at_bound_share;
  const Range& r = u.range;
  if (!std::isfinite(r.hi)) return r.lo + share * (u.start - r.lo);
  const double room = share * (r.hi - r.lo);
  return is_nearer_to_lower_end(r, value) ? r.lo + room : r.hi - room;
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

/// Whether the gradient is rounding: a search that cannot go lower from there has converged.
bool is_flat(gsl_multifit_nlinear_workspace* w) {
  constexpr double rounding = 1e-5;
  double largest = 0.0, norm = 0.0;
  const gsl_vector* f = gsl_multifit_nlinear_residual(w);
  for (std::size_t i = 0; i < f->size; ++i) norm += std::pow(gsl_vector_get(f, i), 2);
  for (std::size_t k = 0; k < w->g->size; ++k)
    largest = std::max(largest, std::abs(gsl_vector_get(w->g, k)));
  return largest <= rounding * std::max(1.0, norm);
}

/// An unknown that is driven out takes the whole trust region: u has no end there.
bool drives_one_out(const Search& s, const gsl_multifit_nlinear_workspace* w) {
  const Eigen::VectorXd values = values_of(s, w->x);
  for (std::size_t i = 0; i < s.free.size(); ++i)
    if (is_driven_out(s.unknown(i), values[s.free[i]], gsl_vector_get(w->g, i))) return true;
  return false;
}

/// GSL's driver, which also stops where an unknown is driven out (GSL_CONTINUE).
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

struct Ended {
  Eigen::VectorXd values;
  int status = GSL_SUCCESS;
};

Ended search_in(Search& search, Precision precision) {
  const double tolerance = precision == Precision::full ? 1e-7 : 1e-5;
  search.difference = precision == Precision::full ? Difference::central : Difference::one_sided;
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
  if (status == GSL_SUCCESS && precision == Precision::full) gsl_multifit_nlinear_iterate(w.get());
  return {values_of(search, gsl_multifit_nlinear_position(w.get())), status};
}

/// Roughly first, then, if asked for, to rounding.
int search_from_values(Search& search, Precision precision) {
  if (search.free.empty()) return GSL_SUCCESS;
  Ended ended = search_in(search, Precision::replicate);
  search.values = ended.values;
  if (precision == Precision::replicate || ended.status == GSL_CONTINUE) return ended.status;
  ended = search_in(search, Precision::full);
  search.values = ended.values;
  return ended.status;
}

/// For each unknown whether it is driven out at the values of a search.
std::vector<bool> driven_out(Search& s) {
  const Eigen::VectorXd gradient =
      jacobian_at(s.problem, s.values).transpose() * residuals_at(s.problem, s.data, s.values);
  s.evaluations += 2 * s.values.size() + 1;
  std::vector<bool> out;
  for (Eigen::Index k = 0; k < s.values.size(); ++k)
    out.push_back(
        is_driven_out(s.problem.unknowns[static_cast<std::size_t>(k)], s.values[k], gradient[k]));
  return out;
}

/// Takes those that are driven out from the free ones; whether there were any.
bool hold(Search& s, const std::vector<bool>& out) {
  const auto is_out = [&](Eigen::Index k) { return out[static_cast<std::size_t>(k)]; };
  for (const Eigen::Index k : s.free)
    if (is_out(k))
      s.values[k] = end_of(s.problem.unknowns[static_cast<std::size_t>(k)], s.values[k]);
  return std::erase_if(s.free, is_out) > 0;
}

/// Whether all that are held would still leave their range.
bool still_held(const Search& s, const std::vector<bool>& out) {
  const auto held = s.values.size() - static_cast<Eigen::Index>(s.free.size());
  return std::ranges::count(out, true) == held;
}

}  // namespace

Solution solve(const Problem& p, const Data& data, const Eigen::VectorXd& start,
               Precision precision) {
  if (p.unknowns.empty()) return {start, residuals_at(p, data, start).squaredNorm(), true, 1, ""};
  gsl_set_error_handler_off();
  Search search{p, data, Difference::central, start, {}};
  for (Eigen::Index k = 0; k < start.size(); ++k) search.free.push_back(k);
  int status = GSL_SUCCESS;
  std::vector<bool> out;
  do {
    status = search_from_values(search, precision);
    out = driven_out(search);
  } while (hold(search, out));
  Solution s;
  s.values = search.values;
  s.chi2 = residuals_at(p, data, s.values).squaredNorm();
  s.evaluations = search.evaluations;
  s.converged = std::isfinite(s.chi2) && status == GSL_SUCCESS && still_held(search, out);
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

#include "calibration/fit/fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace tdbd::calibration {
namespace {

Eigen::VectorXd gradient_at(Search& s) {
  s.evaluations += 2 * s.values.size() + 1;
  return jacobian_at(s.problem, s.values).transpose() * residuals_at(s.problem, s.data, s.values);
}

/// For each unknown, whether it is driven out of its range at the values of a search.
std::vector<bool> driven_out(const Search& s, const Eigen::VectorXd& gradient) {
  std::vector<bool> out;
  for (Eigen::Index k = 0; k < s.values.size(); ++k)
    out.push_back(is_driven_out_of_range(s.problem.unknowns[static_cast<std::size_t>(k)],
                                         s.values[k], gradient[k]));
  return out;
}

/// Fixes the unknowns that are driven out. Returns whether there were any.
bool hold(Search& s, const std::vector<bool>& out) {
  const auto is_out = [&](Eigen::Index k) { return out[static_cast<std::size_t>(k)]; };
  for (const Eigen::Index k : s.free)
    if (is_out(k))
      s.values[k] = end_of(s.problem.unknowns[static_cast<std::size_t>(k)], s.values[k]);
  return std::erase_if(s.free, is_out) > 0;
}

/// Whether all fixed unknowns belong at their ends: the objective decreases outwards, or its
/// minimum is so close to the end that the gain would be negligible.
bool are_fixed_correctly(const Search& s, const Eigen::VectorXd& gradient) {
  constexpr double no_gain = 1e-3;  // in half the sum of squares
  const std::vector<bool> out = driven_out(s, gradient);
  for (Eigen::Index k = 0; k < s.values.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (out[i] || std::ranges::binary_search(s.free, k)) continue;
    if (std::abs(gradient[k]) * end_width(s.problem.unknowns[i]) > no_gain) return false;
  }
  return true;
}

/// Frees unknowns that are fixed although the objective now decreases inwards; each only a few
/// times, because one with a minimum within the width of the end would otherwise alternate forever.
/// Returns whether there were any.
bool release(Search& s, const std::vector<bool>& out, std::vector<int>& releases) {
  constexpr int most_releases = 3;
  const std::size_t before = s.free.size();
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (out[k] || releases[k] == most_releases || std::ranges::binary_search(s.free, i)) continue;
    ++releases[k];
    s.values[i] = inside_of(s.problem.unknowns[k], s.values[i]);
    s.free.insert(std::ranges::lower_bound(s.free, i), i);
  }
  return s.free.size() > before;
}

}  // namespace

namespace {

/// The unknowns with their values: "A1 = 1e+06, A3 = 0.3".
std::string values_text(const Problem& p, const Eigen::VectorXd& values) {
  std::string text;
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    text += fmt::format("{}{} = {:.4g}", k == 0 ? "" : ", ", p.unknowns[k].key,
                        values[static_cast<Eigen::Index>(k)]);
  return text;
}

/// Why a search did not converge. Success of the library alone does not mean that: the search may
/// have stopped where the loads hardly depend on the unknowns, or at the end of a range.
std::string reason_of(const Problem& p, const Solution& s, const Eigen::VectorXd& start,
                      int status) {
  if (status != GSL_SUCCESS) return gsl_strerror(status);
  if (!std::isfinite(s.chi2))
    return fmt::format("the loads are not finite at {}", values_text(p, s.values));
  return fmt::format(
      "the search from {} stopped at {}, where the objective still decreases beyond the ends of "
      "their ranges, or hardly depends on them",
      values_text(p, start), values_text(p, s.values));
}

}  // namespace

Solution solve(const Problem& p, const Data& data, const Eigen::VectorXd& start,
               Precision precision) {
  if (p.unknowns.empty()) return {start, residuals_at(p, data, start).squaredNorm(), true, 1, ""};
  gsl_set_error_handler_off();
  Search search{p, data, start, {}};
  for (Eigen::Index k = 0; k < start.size(); ++k) search.free.push_back(k);
  int status = GSL_SUCCESS;
  std::vector<bool> out;
  std::vector<int> releases(p.unknowns.size(), 0);
  Eigen::VectorXd gradient;
  do {
    status = search_from_values(search);
    gradient = gradient_at(search);
    out = driven_out(search, gradient);
  } while (hold(search, out) || (status == GSL_SUCCESS && release(search, out, releases)));
  const bool settled = status == GSL_SUCCESS && are_fixed_correctly(search, gradient);
  if (settled && precision == Precision::full) polish(search);
  Solution s;
  s.values = search.values;
  s.chi2 = residuals_at(p, data, s.values).squaredNorm();
  s.evaluations = search.evaluations;
  s.converged = settled && std::isfinite(s.chi2);
  if (!s.converged) s.reason = reason_of(p, s, start, status);
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
  std::string places;
  for (const Unknown& u : p.unknowns)
    places += fmt::format("{}{}.start = {:.4g}", places.empty() ? "" : ", ", u.key, u.start);
  throw RunError(
      fmt::format("the fit converges from none of {} starts. From the start of the case: {}. The "
                  "other starts are drawn around it ({}): set a start near the expected value",
                  further_starts + 1, reason, places));
}

namespace {

std::vector<Eigen::Index> inside(const Problem& p, const Eigen::VectorXd& values) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const Unknown& u = p.unknowns[static_cast<std::size_t>(k)];
    if (!is_at_bound(u.range, values[k], u.start)) free.push_back(k);
  }
  return free;
}

/// (J^T J)^-1 of the coefficients that are not at a bound, from the singular values of J.
Eigen::MatrixXd covariance_at(const Problem& p, const Eigen::VectorXd& values) {
  const std::vector<Eigen::Index> free = inside(p, values);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(values.size(), values.size());
  if (free.empty()) return covariance;
  const Eigen::MatrixXd J = jacobian_at(p, values)(Eigen::all, free);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd inverse = svd.singularValues().cwiseInverse();
  const Eigen::MatrixXd half = svd.matrixV() * inverse.asDiagonal();
  covariance(free, free) = half * half.transpose();
  return covariance;
}

FittedCoefficient coefficient_of(const Unknown& u, double value, double variance, double z) {
  FittedCoefficient c{u.key, u.start, value, std::sqrt(variance),
                      value, value,   false, is_at_bound(u.range, value, u.start)};
  c.from_prior = u.prior_sd && (c.at_bound || c.se > prior_dominance * *u.prior_sd);
  if (c.at_bound) return c;
  c.low = std::max(u.range.lo, value - z * c.se);
  c.high = std::min(u.range.hi, value + z * c.se);
  return c;
}

}  // namespace

double two_sided_quantile(double level) { return gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * level); }

Eigen::VectorXd deviations(const Problem& p) {
  Eigen::VectorXd d(static_cast<Eigen::Index>(p.readings()));
  for (const TestBlock& b : p.blocks)
    d.segment(b.first, b.factor.rows()) = b.factor.rowwise().norm();
  return d;
}

Fit fit(Problem problem, const Data& data, const Intervals& intervals) {
  const Solution s = solve_from_starts(problem, data, intervals.seed);
  Fit f{std::move(problem), {}, s.values, {}, {}, {}, {}, 0.0, 0, s.evaluations};
  f.law = law_at(f.problem, s.values);
  f.laws = laws_at(f.problem, s.values);
  f.covariance = covariance_at(f.problem, s.values);
  const double z = two_sided_quantile(intervals.level);
  for (Eigen::Index k = 0; k < s.values.size(); ++k)
    f.coefficients.push_back(coefficient_of(f.problem.unknowns[static_cast<std::size_t>(k)],
                                            s.values[k], f.covariance(k, k), z));
  f.errors = log_loads(f.problem, f.laws) - data.log_loads;
  const Eigen::VectorXd scaled = f.errors.cwiseQuotient(deviations(f.problem));
  for (std::size_t i = 0; i < f.problem.readings(); ++i)
    f.objectives[f.problem.places[i].load] += std::pow(scaled[static_cast<Eigen::Index>(i)], 2);
  Eigen::VectorXd whitened = f.errors;
  whiten(f.problem, whitened);
  f.chi2 = whitened.squaredNorm();
  f.degrees_of_freedom = static_cast<long>(f.problem.rows()) - static_cast<long>(s.values.size());
  return f;
}

Fit fit(const Problem& problem, const Intervals& intervals) {
  return fit(problem, data_of(problem), intervals);
}

}  // namespace tdbd::calibration

#include "calibration/fit/fit.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "calibration/fit/bounded_map.hpp"

namespace tdbd::calibration {
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
  c.from_prior = u.prior_sd && (c.at_bound || c.se > most_of_prior * *u.prior_sd);
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

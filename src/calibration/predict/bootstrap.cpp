#include "calibration/predict/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/predict/normal.hpp"

namespace tdbd::calibration {
namespace {

/// Quantile of a sorted list, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

BootstrapFigures figures_of(std::vector<double> values, double level) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  BootstrapFigures f;
  for (const double v : values) f.mean += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - f.mean) * (v - f.mean);
  f.se = std::sqrt(squares / std::max(1.0, n - 1.0));
  f.low = quantile(values, 0.5 - 0.5 * level);
  f.high = quantile(values, 0.5 + 0.5 * level);
  return f;
}

/// Starting values of replicates: those of the fit, moved off the ends of ranges, where a search
/// cannot move.
Eigen::VectorXd off_ends(const Fit& f) {
  constexpr double share = 0.01;
  Eigen::VectorXd values = f.values;
  for (std::size_t k = 0; k < f.coefficients.size(); ++k)
    if (f.coefficients[k].at_bound)
      values[static_cast<Eigen::Index>(k)] +=
          share * (f.coefficients[k].start - f.coefficients[k].value);
  return values;
}

/// Searches from `start`, then from a few drawn starts, because a search may fail near an end of a
/// range.
Solution solve_replicate(const Problem& p, const Data& data, const Eigen::VectorXd& start,
                         std::uint64_t seed) {
  constexpr std::uint64_t more_starts = 3;
  Solution s = solve(p, data, start, Precision::replicate);
  for (std::uint64_t i = 1; i <= more_starts && !s.converged; ++i)
    s = solve(p, data, drawn_start(p, seed + i), Precision::replicate);
  return s;
}

}  // namespace

Data drawn_data(const Problem& p, const Eigen::VectorXd& values, std::uint64_t seed) {
  Random random{seed};
  Data d = data_of(p);
  const Eigen::VectorXd means = log_loads(p, laws_at(p, values));
  for (const TestBlock& b : p.blocks) {
    Eigen::VectorXd noise(b.factor.rows());
    for (double& x : noise) x = normal(random);
    d.log_loads.segment(b.first, b.factor.rows()) =
        means.segment(b.first, b.factor.rows()) + b.factor * noise;
  }
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    if (const auto& sd = p.unknowns[k].prior_sd)
      d.prior_centres[static_cast<Eigen::Index>(k)] =
          values[static_cast<Eigen::Index>(k)] + *sd * normal(random);
  return d;
}

Bootstrap bootstrap(const Fit& f, const Intervals& intervals) {
  Bootstrap b{intervals.bootstrap, 0, {}};
  std::vector<std::vector<double>> values(f.problem.unknowns.size());
  const Eigen::VectorXd start = off_ends(f);
  Random seeds{intervals.seed};
  for (long i = 0; i < intervals.bootstrap; ++i) {
    const std::uint64_t seed = seeds.next();
    const Solution s =
        solve_replicate(f.problem, drawn_data(f.problem, f.values, seed), start, seed);
    if (!s.converged) {
      ++b.failed;
      continue;
    }
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k].push_back(s.values[static_cast<Eigen::Index>(k)]);
  }
  if (b.failed < b.replicates)
    for (const std::vector<double>& v : values)
      b.coefficients.push_back(figures_of(v, intervals.level));
  return b;
}

}  // namespace tdbd::calibration

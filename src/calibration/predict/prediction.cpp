#include "calibration/predict/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::calibration {
namespace {

/// d log load / d value of the coefficients, by central differences.
Eigen::VectorXd gradient(const Fit& f, const Sample& sample, std::size_t load) {
  constexpr double relative = 1e-5;
  Eigen::VectorXd g = Eigen::VectorXd::Zero(f.values.size());
  for (Eigen::Index k = 0; k < g.size(); ++k) {
    if (f.covariance(k, k) == 0.0) continue;
    const double h = relative * std::max(std::abs(f.values[k]), 1e-12);
    Eigen::VectorXd more = f.values, less = f.values;
    more[k] += h;
    less[k] -= h;
    const Loads up = mean_loads(laws_at(f.problem, more), sample);
    const Loads down = mean_loads(laws_at(f.problem, less), sample);
    g[k] = std::log(up[load] / down[load]) / (2.0 * h);
  }
  return g;
}

PredictedLoad predicted_load(double mean, double variance, double reading_variance, double z) {
  const double reach = z * std::sqrt(variance + reading_variance);
  return {mean, mean * std::sqrt(variance), mean * std::exp(-reach), mean * std::exp(reach)};
}

}  // namespace

Prediction predict(const Fit& f, const Sample& sample, const Record& record, const Noise& noise,
                   const Discrepancy& discrepancy, double level) {
  const double z = two_sided_quantile(level);
  const Loads mean = mean_loads(f.laws, sample), slopes = depth_slopes(f.laws, sample);
  Prediction p{record, {}};
  for (const std::size_t k : {axial, turning}) {
    const Eigen::VectorXd g = gradient(f, sample, k);
    const double variance = g.dot(f.covariance * g);
    const double around = reading_variance(noise, record.readings[k], slopes[k]) +
                          discrepancy.value[k] * discrepancy.value[k];
    p.loads[k] = predicted_load(mean[k], variance, around, z);
  }
  return p;
}

std::array<PredictionError, 2> errors_of(const std::vector<Prediction>& predictions) {
  std::array<PredictionError, 2> errors;
  for (const std::size_t k : {axial, turning}) {
    std::vector<double> e;
    double squares = 0.0;
    for (const Prediction& p : predictions) {
      if (!p.record.readings[k].value) continue;
      e.push_back(std::abs(p.loads[k].mean / *p.record.readings[k].value - 1.0));
      squares += e.back() * e.back();
    }
    if (e.empty()) continue;
    std::sort(e.begin(), e.end());
    const auto n = static_cast<double>(e.size());
    constexpr double percentile = 0.95;
    const auto place = static_cast<std::size_t>(std::ceil(percentile * n)) - 1;
    errors[k] = {std::sqrt(squares / n), e[place], static_cast<long>(e.size())};
  }
  return errors;
}

}  // namespace tdbd::calibration

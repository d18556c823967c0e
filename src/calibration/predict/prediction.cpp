#include "calibration/predict/prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "calibration/fit/quality.hpp"
#include "core/error.hpp"

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
  return {mean, mean * std::sqrt(variance), mean * std::exp(-reach), mean * std::exp(reach), {}};
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
    if (const auto& value = record.readings[k].value)
      p.loads[k].standardised = std::log(mean[k] / *value) / std::sqrt(variance + around);
  }
  return p;
}

std::array<PredictionError, 2> errors_of(const std::vector<Prediction>& predictions) {
  std::array<PredictionError, 2> errors;
  for (const std::size_t k : {axial, turning}) {
    std::vector<double> e;
    double squares = 0.0;
    long within_two = 0;
    for (const Prediction& p : predictions) {
      if (!p.record.readings[k].value) continue;
      e.push_back(std::abs(p.loads[k].mean / *p.record.readings[k].value - 1.0));
      squares += e.back() * e.back();
      within_two += std::abs(p.loads[k].standardised.value_or(0.0)) <= 2.0 ? 1 : 0;
    }
    if (e.empty()) continue;
    std::sort(e.begin(), e.end());
    const auto n = static_cast<double>(e.size());
    constexpr double percentile = 0.95;
    const auto place = static_cast<std::size_t>(std::ceil(percentile * n)) - 1;
    errors[k] = {std::sqrt(squares / n), e[place], e.back(), static_cast<long>(e.size()),
                 within_two};
  }
  return errors;
}

namespace {

/// Quantile of a sorted list, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

BootstrapSummary summarize(std::vector<double> values, double level) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  BootstrapSummary f;
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
Eigen::VectorXd away_from_bounds(const Fit& f) {
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
  const Eigen::VectorXd start = away_from_bounds(f);
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
      b.coefficients.push_back(summarize(v, intervals.level));
  return b;
}

namespace {

std::vector<std::string> tools_of(const std::vector<Record>& records) {
  std::vector<std::string> names;
  for (const Record& r : records)
    if (std::ranges::find(names, r.tool) == names.end()) names.push_back(r.tool);
  return names;
}

/// Squared errors of predictions minus those explained by coefficients and noise.
struct Excess {
  Loads sum{};
  std::array<long, 2> count{};
};

void add(const Fit& f, const CalibrationCase& c, const CutStore& cuts, const Record& r, Excess& e) {
  constexpr double one_deviation = 0.6826894921370859;  // level for z = 1
  const Sample sample = sample_of(c, cuts, r);
  const Prediction p = predict(f, sample, r, c.noise, {}, one_deviation);
  for (const std::size_t k : {axial, turning}) {
    if (!r.readings[k].value) continue;
    const double error = std::log(p.loads[k].mean / *r.readings[k].value);
    const double explained = std::log(p.loads[k].high / p.loads[k].mean);
    e.sum[k] += error * error - explained * explained;
    ++e.count[k];
  }
}

}  // namespace

Discrepancy leave_one_tool_out(const CalibrationCase& c, const CutStore& cuts,
                               const std::vector<Record>& fitted) {
  const std::vector<std::string> tools = tools_of(fitted);
  if (tools.empty()) return {{}, "nothing is fitted"};
  if (tools.size() == 1) return {{}, "only one bit is fitted"};
  Excess excess;
  for (const std::string& left_out : tools) {
    std::vector<Record> rest;
    for (const Record& r : fitted)
      if (r.tool != left_out) rest.push_back(r);
    try {
      const Problem problem = problem_of(c, cuts, rest);
      require_identifiable(problem);
      const Fit f = fit_with_loss(c, cuts, problem);
      for (const Record& r : fitted)
        if (r.tool == left_out) add(f, c, cuts, r, excess);
    } catch (const InputError&) {
      return {{}, "without " + left_out + " the coefficients are not identifiable"};
    } catch (const RunError& e) {
      return {{}, "without " + left_out + ": " + e.what()};
    }
  }
  Discrepancy d;
  for (const std::size_t k : {axial, turning})
    if (excess.count[k] > 0)
      d.value[k] = std::sqrt(std::max(0.0, excess.sum[k] / static_cast<double>(excess.count[k])));
  return d;
}

namespace {

/// A quantity of a sample that is compared with the range of the fitted records.
struct Feature {
  const char* name;
  const char* unit;
  double scale;  ///< factor from SI to the unit
  std::function<double(const Sample&)> of;
};

/// Mean over the faces, weighted by cut area.
template <class Value>
double over_faces(const Sample& s, Value value) {
  double sum = 0.0, weight = 0.0;
  for (const forces::PartCut& cut : s.cuts) {
    sum += cut.cut_area * value(cut);
    weight += cut.cut_area;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {"mean back rake", "deg", 180.0 / pi,
       [](const Sample& s) {
         return over_faces(s, [](const auto& cut) { return cut.back_rake; });
       }},
      {"cutter diameter", "mm", 1e3,
       [](const Sample& s) { return over_faces(s, [](const auto& cut) { return cut.diameter; }); }},
      {"thickness of the cut", "mm", 1e3,
       [](const Sample& s) { return over_faces(s, [](const auto& cut) { return cut.depth; }); }},
      {"pressure", "MPa", 1e-6,
       [](const Sample& s) { return s.cuts.empty() ? 0.0 : s.cuts.front().strength.pressure; }}};
  return all;
}

}  // namespace

std::vector<std::string> extrapolations(const std::vector<Sample>& fitted,
                                        const std::vector<Sample>& predicted) {
  constexpr double allowance = 0.01;  // of the largest value: rounding, mesh scatter
  std::vector<std::string> found;
  if (fitted.empty() || predicted.empty()) return found;
  for (const Feature& f : features()) {
    const auto [lo, hi] = std::ranges::minmax(fitted, {}, f.of);
    const auto [below, above] = std::ranges::minmax(predicted, {}, f.of);
    const double least = f.of(lo), most = f.of(hi), slack = allowance * most;
    if (f.of(below) >= least - slack && f.of(above) <= most + slack) continue;
    found.push_back(fmt::format("{}: {:.3g} to {:.3g} {} predicted, {:.3g} to {:.3g} {} fitted",
                                f.name, f.scale * f.of(below), f.scale * f.of(above), f.unit,
                                f.scale * least, f.scale * most, f.unit));
  }
  return found;
}

}  // namespace tdbd::calibration

#include <algorithm>
#include <cmath>

#include "calibration/fit/identifiability.hpp"
#include "calibration/predict/prediction.hpp"
#include "core/error.hpp"

namespace tdbd::calibration {
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
      const Fit f = fit(problem, c.intervals);
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

}  // namespace tdbd::calibration

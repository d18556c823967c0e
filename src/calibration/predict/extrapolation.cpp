#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "calibration/predict/prediction.hpp"

namespace tdbd::calibration {
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

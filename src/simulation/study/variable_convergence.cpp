#include "simulation/study/variable_convergence.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::simulation {
namespace {

/// Safety factors of the grid convergence index: with an observed order, and without.
constexpr double observed_factor = 1.25, cautious_factor = 3.0;

/// Smaller orders are noise rather than convergence. `usual_order` is the largest order assumed if
/// the method states none.
constexpr double least_order = 0.5, usual_order = 2.0;

/// (9): remainder of a geometric series after the difference between level `index` and the next.
double error_after(std::span<const double> sizes, double difference, std::size_t index,
                   double order) {
  return difference / (std::pow(sizes[index] / sizes[index + 1], order) - 1.0);
}

/// Median slope of all pairs (Theil 1950, Sen 1968). In a least-squares fit, one difference that is
/// small by chance would increase the slope and make the estimate too small.
double median_slope(std::span<const double> sizes, std::span<const double> differences) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < differences.size(); ++i)
    for (std::size_t j = i + 1; j < differences.size(); ++j)
      if (differences[i] > 0.0 && differences[j] > 0.0)
        slopes.push_back(std::log(differences[i] / differences[j]) / std::log(sizes[i] / sizes[j]));
  if (slopes.empty()) return 0.0;
  std::ranges::sort(slopes);
  const std::size_t n = slopes.size();
  return 0.5 * (slopes[(n - 1) / 2] + slopes[n / 2]);
}

/// (11): the largest of scattered differences, each scaled to the finest size along the slope,
/// because the finest difference may be small by chance.
double envelope(std::span<const double> sizes, std::span<const double> differences, double order) {
  const double finest = sizes[differences.size() - 1];
  double largest = 0.0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    largest = std::max(largest, differences[i] * std::pow(finest / sizes[i], order));
  return largest;
}

}  // namespace

Uncertainty uncertainty_of(const ObservedOrder& observed, std::span<const double> sizes,
                           std::span<const double> differences, double nominal, double range) {
  if (observed.verdict == OrderVerdict::exact) return {UncertaintyBasis::exact};
  const double most = nominal > 0.0 ? nominal : usual_order;
  const auto estimate = [&](UncertaintyBasis basis, double order, double factor, double difference,
                            std::size_t index) -> Uncertainty {
    const double error = error_after(sizes, difference, index, order);
    return {basis, order, factor, error, factor * error};
  };
  if (observed.verdict == OrderVerdict::order && observed.order >= least_order) {
    const std::size_t last = at(observed.first + observed.used - 1);
    return estimate(UncertaintyBasis::observed_order, std::min(observed.order, most),
                    observed_factor, differences[last], last);
  }
  const double slope = std::min(median_slope(sizes, differences), most);
  if (observed.above_floor >= 2 && slope >= least_order) {
    return estimate(UncertaintyBasis::slope, slope, cautious_factor,
                    envelope(sizes, differences, slope), differences.size() - 1);
  }
  return {UncertaintyBasis::range, 0.0, cautious_factor, range, cautious_factor * range};
}

const char* name_of(UncertaintyBasis basis) {
  switch (basis) {
    case UncertaintyBasis::exact:
      return "exact";
    case UncertaintyBasis::observed_order:
      return "observed order";
    case UncertaintyBasis::slope:
      return "slope of all differences";
    case UncertaintyBasis::range:
      break;
  }
  return "range of the levels";
}

namespace {

using Levels = std::vector<ConvergenceLevel>;

std::vector<double> first_sizes(const Levels& levels) {
  std::vector<double> sizes;
  for (const ConvergenceLevel& level : levels) sizes.push_back(level.sizes.front());
  return sizes;
}

/// Observed orders of errors relative to a reference (one per level) or between successive levels
/// (one less).
void observe_order(const Levels& levels, VariableConvergence& v) {
  std::vector<double> sizes = first_sizes(levels);
  std::vector<long> counts;  // for a difference: that of the longer of its two runs
  for (const ConvergenceLevel& level : levels) counts.push_back(level.steps);
  if (v.differences.size() < levels.size()) counts.erase(counts.begin());
  sizes.resize(v.differences.size());
  v.order = observed_order(sizes, v.differences, v.scale, counts);
}

/// The largest distance between the final values of any two levels.
double range_of(const Levels& levels, std::size_t v) {
  double range = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      range = std::max(range, distance(levels[i].end.variables[v], levels[j].end.variables[v]));
  return range;
}

void estimate_uncertainty(const Levels& levels, double nominal_order, double range,
                          VariableConvergence& v) {
  if (!v.differences.empty())
    v.uncertainty =
        uncertainty_of(v.order, first_sizes(levels), v.differences, nominal_order, range);
}

/// (10): adds the remainder of the series after the last difference to the finest values.
void extrapolate(const Levels& levels, std::size_t v, VariableConvergence& r) {
  // After an interruption there may be only one level and no uncertainty.
  if (!r.uncertainty || r.uncertainty->basis != UncertaintyBasis::observed_order) return;
  const StateVariable& fine = levels.back().end.variables[v];
  const ConvergenceLevel& before = levels[levels.size() - 2];
  const bool is_attitude = fine.factor != 1.0;
  if (is_attitude || fine.values.size() != before.end.variables[v].values.size()) return;
  const double ratio =
      std::pow(before.sizes.front() / levels.back().sizes.front(), r.uncertainty->order);
  for (std::size_t k = 0; k < fine.values.size(); ++k)
    r.extrapolated.push_back(fine.values[k] +
                             (fine.values[k] - before.end.variables[v].values[k]) / (ratio - 1.0));
}

VariableConvergence against_reference(const Levels& levels, std::size_t v,
                                      const StateVariable& reference) {
  const StateVariable& first = levels.front().end.variables[v];
  VariableConvergence r{first.name, first.units};
  for (const ConvergenceLevel& level : levels) {
    const StateVariable& one = level.end.variables[v];
    r.scale = std::max(r.scale, one.scale);
    r.differences.push_back(distance(one, reference));
  }
  observe_order(levels, r);
  return r;
}

VariableConvergence between_levels(const Levels& levels, std::size_t v, double nominal_order) {
  const StateVariable& first = levels.front().end.variables[v];
  VariableConvergence r{first.name, first.units};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const StateVariable& one = levels[i].end.variables[v];
    r.scale = std::max(r.scale, one.scale);
    if (i > 0) r.differences.push_back(distance(levels[i - 1].end.variables[v], one));
  }
  observe_order(levels, r);
  estimate_uncertainty(levels, nominal_order, range_of(levels, v), r);
  extrapolate(levels, v, r);
  return r;
}

/// Convergence of the distance between holes that `of` selects.
VariableConvergence of_holes(const Levels& levels, double nominal_order, VariableConvergence r,
                             double HoleDifference::*of) {
  for (std::size_t i = 1; i < levels.size(); ++i) r.differences.push_back((*levels[i].moved).*of);
  observe_order(levels, r);
  double range = 0.0;  // sum over successive levels: an upper bound by the triangle inequality
  for (const double d : r.differences) range += d;
  estimate_uncertainty(levels, nominal_order, range, r);
  return r;
}

/// The variable with that name; null if there is none.
const StateVariable* find(const EndState& end, const std::string& name) {
  const auto is_it = [&](const StateVariable& v) { return v.name == name; };
  const auto found = std::ranges::find_if(end.variables, is_it);
  return found == end.variables.end() ? nullptr : &*found;
}

void add_holes(const Levels& levels, double nominal_order,
               std::vector<VariableConvergence>& variables) {
  if (levels.size() < 2 || !levels.back().moved) return;
  double radius = 0.0, removed = 0.0;
  for (const ConvergenceLevel& level : levels) {
    if (level.moved) radius = std::max(radius, level.moved->radius);
    removed = std::max(removed, find(level.end, "removed_volume")->scale);
  }
  variables.push_back(
      of_holes(levels, nominal_order, {"surface_distance", "m", radius}, &HoleDifference::largest));
  variables.push_back(
      of_holes(levels, nominal_order, {"volume_between", "m3", removed}, &HoleDifference::volume));
}

}  // namespace

std::vector<VariableConvergence> observe(const Levels& levels, const Yardstick& y) {
  std::vector<VariableConvergence> variables;
  if (levels.empty()) return variables;
  const EndState& first = levels.front().end;
  for (std::size_t v = 0; v < first.variables.size(); ++v) {
    if (!y.reference)
      variables.push_back(between_levels(levels, v, y.nominal_order));
    else if (const StateVariable* r = find(*y.reference, first.variables[v].name))
      variables.push_back(against_reference(levels, v, *r));
  }
  if (!y.reference) add_holes(levels, y.nominal_order, variables);
  return variables;
}

}  // namespace tdbd::simulation

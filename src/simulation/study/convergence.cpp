#include "simulation/study/convergence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "simulation/case/case.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {
namespace {

/// Tolerance for the end times of levels; scale: the duration.
constexpr double same_duration = 1e-9;

constexpr const char* step_key = "time.step";

double quantity_of(const std::string& key, const std::map<std::string, double>& quantities) {
  const auto at = quantities.find(key);
  if (at == quantities.end()) {
    std::vector<std::string> names;
    names.reserve(quantities.size());
    for (const auto& [name, value] : quantities) names.push_back(name);
    throw InputError(fmt::format("--over: found {}, expected a quantity of the case: {}", key,
                                 nearest_name(key, names).value_or("time.step, for example")));
  }
  if (!(at->second > 0.0))
    throw InputError(fmt::format("--over: {}: found {}, expected a quantity > 0", key, at->second));
  return at->second;
}

std::vector<double> quantities_of(const ConvergencePlan& plan,
                                  const std::map<std::string, double>& quantities) {
  std::vector<double> sizes;
  for (const std::string& key : plan.keys) {
    if (std::ranges::count(plan.keys, key) > 1)
      throw InputError(fmt::format("--over: found {} twice, expected every quantity once", key));
    sizes.push_back(quantity_of(key, quantities));
  }
  return sizes;
}

/// "time.step=0.005", with enough digits to restore the value bitwise.
std::string override_of(const std::string& key, double size) {
  return fmt::format("{}={:.17e}", key, size);
}

/// A variable of `b` that has another number of values than in `a`; null if there is none.
const StateVariable* unlike(const EndState& a, const EndState& b) {
  for (const StateVariable& x : a.variables)
    for (const StateVariable& y : b.variables)
      if (x.name == y.name && !x.grows && x.values.size() != y.values.size()) return &y;
  return nullptr;
}

void require_same_variables(const EndState& level, const EndState& other, const std::string& what) {
  if (level.command != other.command)
    throw InputError(fmt::format("{}: found the state of a {} case, expected that of a {} case",
                                 what, other.command, level.command));
  if (const StateVariable* v = unlike(level, other))
    throw InputError(fmt::format("{}: found {} with {} values, expected as many as in the case",
                                 what, v->name, v->values.size()));
  if (std::abs(level.duration - other.duration) > same_duration * level.duration)
    throw InputError(
        fmt::format("{}: found an end at t = {} s, expected {} s, as of the first level (choose "
                    "steps that divide the duration)",
                    what, other.duration, level.duration));
}

/// Sizes of the quantities at level `i`, from 0. A time step is the closest one that divides the
/// duration.
std::vector<double> sizes_at(const ConvergencePlan& plan, const ConvergenceStart& first, int i) {
  std::vector<double> sizes = first.sizes;
  for (std::size_t k = 0; k < sizes.size() && i > 0; ++k) {
    sizes[k] /= std::pow(plan.factor, i);
    if (plan.keys[k] == step_key) sizes[k] = first.duration / std::round(first.duration / sizes[k]);
  }
  return sizes;
}

std::vector<std::string> overrides_at(const ConvergencePlan& plan,
                                      const std::vector<double>& sizes) {
  std::vector<std::string> overrides = plan.overrides;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    overrides.push_back(override_of(plan.keys[k], sizes[k]));
  return overrides;
}

std::string level_text(const ConvergencePlan& plan, int i, const std::vector<double>& sizes) {
  std::string text = fmt::format("level {}", i + 1);
  for (std::size_t k = 0; k < sizes.size(); ++k)
    text += fmt::format(", {} = {}", plan.keys[k], sizes[k]);
  return text;
}

/// The sizes as used: a time step is changed so that it divides the duration.
std::vector<double> used_sizes(const ConvergencePlan& plan, std::vector<double> sizes,
                               double step) {
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (plan.keys[k] == step_key) sizes[k] = step;
  return sizes;
}

bool divides_step(const ConvergencePlan& plan) {
  return std::ranges::count(plan.keys, step_key) > 0;
}

/// Checks that the last level is consistent with the previous ones.
void check_last(const Convergence& c) {
  const std::size_t i = c.levels.size() - 1;
  if (i == 0 && c.plan.reference)
    require_same_variables(c.levels.front().end, *c.plan.reference, "--reference");
  require_same_variables(c.levels.front().end, c.levels.back().end, fmt::format("level {}", i + 1));
  if (c.levels.front().end.variables.size() != c.levels.back().end.variables.size())
    throw InputError(
        fmt::format("level {}: found other state variables, expected those of the "
                    "first level",
                    i + 1));
  if (i > 0 && divides_step(c.plan) && c.levels[i].steps == c.levels[i - 1].steps)
    throw InputError(
        fmt::format("--factor: level {}: found {} steps, as at level {}, expected more: "
                    "take a larger factor",
                    i + 1, c.levels[i].steps, i));
}

/// Runs level `i`. Returns whether it was completed. `last` is the hole of the previous level.
bool add_level(Convergence& c, const ConvergenceStart& first, int i, std::optional<Hole>& last,
               const ConvergenceOptions& options) {
  const std::vector<double> sizes = sizes_at(c.plan, first, i);
  const std::vector<std::string> overrides = overrides_at(c.plan, sizes);
  try {
    LevelOutcome o = run_level(c.plan.case_file, overrides, i + 1, options);
    if (o.status == RunStatus::interrupted) return false;
    c.levels.push_back(
        {used_sizes(c.plan, sizes, o.step), o.steps, std::move(o.end), {}, o.evaluations});
    if (last && o.hole) c.levels.back().moved = difference(*last, *o.hole);
    last = std::move(o.hole);
  } catch (const RunError& e) {
    throw RunError(fmt::format("{}: {}", level_text(c.plan, i, sizes), e.what()));
  }
  check_last(c);
  return true;
}

/// The order in the time step. Unknown (0) for other quantities, and for several quantities
/// together.
double nominal_order(const ConvergencePlan& plan, double in_step) {
  return plan.keys.size() == 1 && divides_step(plan) ? in_step : 0.0;
}

ConvergenceStart check_rotate(const ConvergencePlan& plan) {
  const RotateCase c = read_rotate_case(plan.case_file, plan.overrides);
  return {quantities_of(plan, c.quantities),
          c.title,
          c.hash,
          c.files,
          nominal_order(plan, c.integrator.order),
          c.time.step * static_cast<double>(c.time.steps)};
}

/// Rock vertices move along paths that are straight to second order in the time step.
ConvergenceStart check_run(const ConvergencePlan& plan) {
  const Case c = read_case(plan.case_file, plan.overrides);
  constexpr double in_step = 2.0;
  return {quantities_of(plan, c.quantities),
          c.bit.name,
          c.hash,
          c.files,
          nominal_order(plan, in_step),
          c.time.step * static_cast<double>(c.time.steps)};
}

ConvergenceStart check_first(const ConvergencePlan& plan) {
  return is_rotate_case(plan.case_file) ? check_rotate(plan) : check_run(plan);
}

/// Reads the case as level `i` will, so that an invalid level is reported before the first one
/// runs.
void check_level(const ConvergencePlan& plan, const ConvergenceStart& first, int i) {
  const std::vector<double> sizes = sizes_at(plan, first, i);
  const std::string level = level_text(plan, i, sizes);
  ConvergencePlan one = plan;
  one.overrides = overrides_at(plan, sizes);
  try {
    const ConvergenceStart start = check_first(one);
    if (std::abs(start.duration - first.duration) > same_duration * first.duration)
      throw InputError(fmt::format("found an end at t = {} s, expected {} s, as of the first level",
                                   start.duration, first.duration));
  } catch (const InputError& e) {
    throw InputError(fmt::format("--over: {}: {}", level, e.what()));
  }
}

}  // namespace

std::string keys_in_words(const ConvergencePlan& plan) {
  return fmt::format("{}", fmt::join(plan.keys, " and "));
}

std::string error_name(const ConvergencePlan& plan) {
  return plan.reference ? "errors" : "differences";
}

ConvergenceStart check(const ConvergencePlan& plan) {
  if (plan.keys.empty()) throw InputError("--over: found none, expected a quantity of the case");
  if (plan.levels < least_levels || plan.levels > most_levels)
    throw InputError(fmt::format("--levels: found {}, expected {} to {}", plan.levels, least_levels,
                                 most_levels));
  if (!(plan.factor > 1.0) || !std::isfinite(plan.factor))
    throw InputError(fmt::format("--factor: found {}, expected a number > 1", plan.factor));
  const ConvergenceStart first = check_first(plan);
  for (const int i : {1, plan.levels - 1}) check_level(plan, first, i);
  return first;
}

Convergence converge(const ConvergencePlan& plan, const ConvergenceOptions& options) {
  const ConvergenceStart start = check(plan);
  Convergence c{plan, RunStatus::completed, start.title, start.case_hash, start.nominal_order, {},
                {}};
  std::optional<Hole> hole;
  for (int i = 0; i < plan.levels && c.status == RunStatus::completed; ++i)
    if (!add_level(c, start, i, hole, options)) c.status = RunStatus::interrupted;
  c.variables = observe(c.levels, {plan.reference, start.nominal_order});
  return c;
}

}  // namespace tdbd::simulation

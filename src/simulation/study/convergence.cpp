#include "simulation/study/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/parallel.hpp"
#include "simulation/case/case.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_run.hpp"
#include "simulation/rotate/rotate_summary.hpp"

namespace tdbd::simulation {
namespace {

/// Levels end at the same time to this; scale: the duration.
constexpr double same_duration = 1e-9;

constexpr const char* step_key = "time.step";

double quantity_of(const ConvergencePlan& plan, const std::map<std::string, double>& quantities) {
  const auto at = quantities.find(plan.key);
  if (at == quantities.end()) {
    std::vector<std::string> names;
    names.reserve(quantities.size());
    for (const auto& [key, value] : quantities) names.push_back(key);
    throw InputError(fmt::format("--over: found {}, expected a quantity of the case: {}", plan.key,
                                 nearest_name(plan.key, names).value_or("time.step, for one")));
  }
  if (!(at->second > 0.0))
    throw InputError(
        fmt::format("--over: {}: found {}, expected a quantity > 0", plan.key, at->second));
  return at->second;
}

/// "time.step=0.005", in digits that read back to the bit.
std::string override_of(const ConvergencePlan& plan, double size) {
  return fmt::format("{}={:.17e}", plan.key, size);
}

/// The same variables, each with as many values.
bool is_like(const EndState& a, const EndState& b) {
  const auto like = [](const StateVariable& x, const StateVariable& y) {
    return x.name == y.name && x.values.size() == y.values.size();
  };
  return a.command == b.command && std::equal(a.variables.begin(), a.variables.end(),
                                              b.variables.begin(), b.variables.end(), like);
}

void require_same_variables(const EndState& level, const EndState& other, const std::string& what) {
  if (!is_like(level, other))
    throw InputError(
        fmt::format("{}: found other state variables, expected those of the case", what));
  if (std::abs(level.duration - other.duration) > same_duration * level.duration)
    throw InputError(
        fmt::format("{}: found an end at t = {} s, expected {} s, as of the first level (choose "
                    "steps that divide the duration)",
                    what, other.duration, level.duration));
}

/// Errors of variable v: of every level against the reference, or against the next level.
std::vector<double> errors_of(const Convergence& c, std::size_t v) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < c.levels.size(); ++i) {
    if (!c.plan.reference && i + 1 == c.levels.size()) break;
    const EndState& other = c.plan.reference ? *c.plan.reference : c.levels[i + 1].end;
    errors.push_back(distance(c.levels[i].end.variables[v], other.variables[v]));
  }
  return errors;
}

VariableConvergence observe(const Convergence& c, std::size_t v) {
  const StateVariable& first = c.levels.front().end.variables[v];
  VariableConvergence r{first.name, first.units, 0.0, errors_of(c, v), {}};
  std::vector<double> sizes;
  std::vector<long> counts;  // of a difference: of the longer of its two runs
  for (const ConvergenceLevel& level : c.levels) {
    sizes.push_back(level.size);
    counts.push_back(level.steps);
    r.scale = std::max(r.scale, level.end.variables[v].scale);
  }
  if (!c.plan.reference) counts.erase(counts.begin());
  sizes.resize(r.differences.size());
  r.order = observed_order(sizes, r.differences, r.scale, counts);
  return r;
}

/// One level of a study, as a summary.
struct LevelOutcome {
  RunStatus status = RunStatus::completed;
  double step = 0.0;  ///< s, the one that was used
  long steps = 0;
  std::string summary;
};

LevelOutcome rotate_level(const std::string& file, const std::vector<std::string>& overrides,
                          int number, const ConvergenceOptions& o) {
  const RotateCase c = read_rotate_case(file, overrides);
  RotateOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](long done, long total) { o.progress(number, done, total); };
  RotateSimulation s = start(c);
  std::vector<double> step_seconds;
  const RunStatus status = rotate_steps(c, s, options, {}, step_seconds);
  return {status, c.time.step, s.steps_done, summary_json(c, s, status)};
}

LevelOutcome drill_level(const std::string& file, const std::vector<std::string>& overrides,
                         int number, const ConvergenceOptions& o) {
  const Case c = read_case(file, overrides);
  const ThreadLimit limit(o.threads);
  Simulation s = start(c);
  RunStatus status = RunStatus::completed;
  while (s.state.steps_done < c.time.steps && status == RunStatus::completed) {
    step(c, s);
    if (o.progress) o.progress(number, s.state.steps_done, c.time.steps);
    if (o.interrupted && *o.interrupted) status = RunStatus::interrupted;
  }
  return {status, c.time.step, s.state.steps_done, to_json(summary_of(c, s, status))};
}

/// Runs a case in memory, a rotate case or a run; `number` is the level's, for the progress.
LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& o) {
  return is_rotate_case(case_file) ? rotate_level(case_file, overrides, number, o)
                                   : drill_level(case_file, overrides, number, o);
}

/// Of the quantity at level `i`, from 0.
double size_at(const ConvergencePlan& plan, double first_size, int i) {
  return first_size / std::pow(plan.factor, i);
}

std::vector<std::string> overrides_at(const ConvergencePlan& plan, double size) {
  std::vector<std::string> overrides = plan.overrides;
  overrides.push_back(override_of(plan, size));
  return overrides;
}

std::string level_text(const ConvergencePlan& plan, int i, double size) {
  return fmt::format("level {}, {} = {}", i + 1, plan.key, size);
}

/// Runs level `i`; whether it came to its end.
bool add_level(Convergence& c, double first_size, int i, const ConvergenceOptions& options) {
  const double size = size_at(c.plan, first_size, i);
  const std::vector<std::string> overrides = overrides_at(c.plan, size);
  try {
    const LevelOutcome o = run_level(c.plan.case_file, overrides, i + 1, options);
    if (o.status == RunStatus::interrupted) return false;
    c.levels.push_back({c.plan.key == step_key ? o.step : size, o.steps,
                        read_end_state(o.summary, "the level's summary")});
  } catch (const RunError& e) {
    throw RunError(fmt::format("{}: {}", level_text(c.plan, i, size), e.what()));
  }
  if (i == 0 && c.plan.reference)
    require_same_variables(c.levels.front().end, *c.plan.reference, "--reference");
  require_same_variables(c.levels.front().end, c.levels.back().end, fmt::format("level {}", i + 1));
  if (i > 0 && c.plan.key == step_key && c.levels[i].steps == c.levels[i - 1].steps)
    throw InputError(
        fmt::format("--factor: level {}: found {} steps, as at level {}, expected more: "
                    "take a larger factor",
                    i + 1, c.levels[i].steps, i));
  return true;
}

ConvergenceStart check_rotate(const ConvergencePlan& plan) {
  const RotateCase c = read_rotate_case(plan.case_file, plan.overrides);
  const double nominal = plan.key == step_key ? c.integrator.order : 0;
  return {quantity_of(plan, c.quantities),
          c.title,
          c.hash,
          c.files,
          nominal,
          c.time.step * static_cast<double>(c.time.steps)};
}

/// Rock vertices move along paths that are straight to second order in the step.
ConvergenceStart check_run(const ConvergencePlan& plan) {
  const Case c = read_case(plan.case_file, plan.overrides);
  const double nominal = plan.key == step_key ? 2.0 : 0.0;
  return {quantity_of(plan, c.quantities),
          c.bit.name,
          c.hash,
          c.files,
          nominal,
          c.time.step * static_cast<double>(c.time.steps)};
}

ConvergenceStart check_first(const ConvergencePlan& plan) {
  return is_rotate_case(plan.case_file) ? check_rotate(plan) : check_run(plan);
}

/// Reads the case as level `i` will: a wrong level is reported before the first one runs.
void check_level(const ConvergencePlan& plan, const ConvergenceStart& first, int i) {
  const double size = size_at(plan, first.size, i);
  const std::string level = level_text(plan, i, size);
  ConvergencePlan one = plan;
  one.overrides = overrides_at(plan, size);
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

std::string error_name(const ConvergencePlan& plan) {
  return plan.reference ? "errors" : "differences";
}

ConvergenceStart check(const ConvergencePlan& plan) {
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
  for (int i = 0; i < plan.levels && c.status == RunStatus::completed; ++i)
    if (!add_level(c, start.size, i, options)) c.status = RunStatus::interrupted;
  if (!c.levels.empty())
    for (std::size_t v = 0; v < c.levels.front().end.variables.size(); ++v)
      c.variables.push_back(observe(c, v));
  return c;
}

}  // namespace tdbd::simulation

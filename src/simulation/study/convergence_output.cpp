#include "simulation/study/convergence_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/whole_file.hpp"
#include "simulation/result/summary.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

const char* verdict_name(OrderVerdict v) {
  switch (v) {
    case OrderVerdict::order:
      return "order";
    case OrderVerdict::exact:
      return "exact";
    case OrderVerdict::too_few:
      return "too few";
    case OrderVerdict::not_settled:
      break;
  }
  return "not settled";
}

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json uncertainty_json(const Uncertainty& u) {
  return {{"value", u.value},
          {"basis", name_of(u.basis)},
          {"order", u.order},
          {"factor", u.factor},
          {"error", u.error}};
}

Json variable_json(const VariableConvergence& v, const std::string& errors) {
  const bool has_order = v.order.verdict == OrderVerdict::order;
  Json local = Json::array();
  for (const double order : v.order.local_orders) local.push_back(number_or_null(order));
  return {{"units", v.units},
          {"scale", v.scale},
          {errors, v.differences},
          {"local_orders", local},
          {"verdict", verdict_name(v.order.verdict)},
          {"order", has_order ? Json(v.order.order) : Json(nullptr)},
          {"first_used", v.order.first},
          {"used", v.order.used},
          {"above_floor", v.order.above_floor},
          {"order_of_all", v.order.order_of_all},
          {"in_words", in_words(v.order, errors)},
          {"extrapolated", v.extrapolated.empty() ? Json() : Json(v.extrapolated)},
          {"uncertainty", v.uncertainty ? uncertainty_json(*v.uncertainty) : Json()}};
}

Json levels_json(const Convergence& c) {
  Json levels = Json::array();
  for (const ConvergenceLevel& level : c.levels) {
    Json state = Json::object();
    for (const StateVariable& v : level.end.variables) state[v.name] = v.values;
    Json one{{"size", level.sizes.front()}, {"sizes", level.sizes}, {"steps", level.steps}};
    if (level.evaluations > 0) one["torque_evaluations"] = level.evaluations;
    one["state"] = state;
    levels.push_back(one);
  }
  return levels;
}

std::size_t error_count(const Convergence& c) {
  return c.variables.empty() ? 0 : c.variables.front().differences.size();
}

/// The unit in brackets. Only those of steps and edges are known here; the others are SI.
const char* unit_text(const std::string& key) {
  if (key == "time.step") return "[s]";
  return key.ends_with("edge_length") ? "[m]" : "[SI]";
}

/// A line of the table: a name, and one number per level.
template <class List, class Text>
std::string row_text(const std::string& name, const List& list, Text&& text) {
  std::string row = fmt::format("{:<34}", name);
  for (const auto& one : list) row += fmt::format(" {:>11}", text(one));
  return row + "\n";
}

/// Digits that are significant given the uncertainty, plus one; at most those of a double.
std::string value_text(double value, double uncertainty) {
  const double digits = std::log10(std::abs(value) / uncertainty) + 3.0;
  const int shown = std::isfinite(digits) ? std::clamp(static_cast<int>(digits), 2, 15) : 6;
  return fmt::format("{:.{}g}", value, shown);
}

/// "12.50 +- 0.31 N (observed order)"; without the value if there are several.
std::string uncertainty_text(const Convergence& c, std::size_t i) {
  const VariableConvergence& v = c.variables[i];
  if (!v.uncertainty) return "";
  if (v.uncertainty->basis == UncertaintyBasis::exact) return "";
  std::string text;
  const std::vector<StateVariable>& finest = c.levels.back().end.variables;
  if (i < finest.size() && finest[i].values.size() == 1)
    text = value_text(finest[i].values.front(), v.uncertainty->value) + " ";
  return fmt::format("{}+- {:.2g} {} ({})", text, v.uncertainty->value, v.units,
                     name_of(v.uncertainty->basis));
}

std::string order_text(const Convergence& c, std::size_t i, const std::string& errors) {
  const VariableConvergence& v = c.variables[i];
  const std::string uncertainty = uncertainty_text(c, i);
  return fmt::format("  {:<30} {}{}{}\n", v.name, in_words(v.order, errors),
                     uncertainty.empty() ? "" : "; ", uncertainty);
}

/// Whether the table states an uncertainty, which holds under an assumption.
bool states_uncertainty(const Convergence& c) {
  return std::ranges::any_of(c.variables, [](const VariableConvergence& v) {
    return v.uncertainty && v.uncertainty->basis != UncertaintyBasis::exact;
  });
}

}  // namespace

std::string table_text(const Convergence& c) {
  const std::string errors = error_name(c.plan);
  std::string out =
      fmt::format("{} of {} divided by {:g} over {} levels, {} {}\n", keys_in_words(c.plan),
                  c.plan.case_file, c.plan.factor, c.levels.size(), errors,
                  c.plan.reference ? "against the reference" : "to the next level");
  for (std::size_t k = 0; k < c.plan.keys.size(); ++k)
    out += row_text(fmt::format("{} {}", c.plan.keys[k], unit_text(c.plan.keys[k])), c.levels,
                    [&](const ConvergenceLevel& l) { return fmt::format("{:.6g}", l.sizes[k]); });
  out += row_text("steps", c.levels,
                  [](const ConvergenceLevel& l) { return fmt::format("{}", l.steps); });
  for (const VariableConvergence& v : c.variables)
    out += row_text(fmt::format("{} [{}]", v.name, v.units), v.differences,
                    [](double d) { return fmt::format("{:.4e}", d); });
  out += "observed orders";
  out += c.plan.reference ? "\n" : "; the finest level with its numerical uncertainty\n";
  for (std::size_t i = 0; i < c.variables.size(); ++i) out += order_text(c, i, errors);
  if (states_uncertainty(c))
    out +=
        "The uncertainty assumes that errors continue to decrease as between these levels. It "
        "contains no error of the model.\n";
  return out;
}

std::string to_json(const Convergence& c) {
  const std::string errors = error_name(c.plan);
  Json json = summary_head("converge", c.title, c.status, c.case_hash, 0);
  Json variables = Json::object();
  for (const VariableConvergence& v : c.variables) variables[v.name] = variable_json(v, errors);
  json.update(Json{{"over", keys_in_words(c.plan)},
                   {"keys", c.plan.keys},
                   {"factor", c.plan.factor},
                   {"against", c.plan.reference ? "reference" : "next level"},
                   {"nominal_order", c.nominal_order > 0.0 ? Json(c.nominal_order) : Json(nullptr)},
                   {"floor", order_floor},
                   {"floor_per_step", order_rounding_per_step},
                   {"exact_below_floor_times", order_exact},
                   {"settled_within", order_scatter_limit},
                   {"levels", levels_json(c)},
                   {"variables", variables}});
  return json.dump(2) + "\n";
}

std::string to_csv(const Convergence& c) {
  std::string out = fmt::format("{},steps", fmt::join(c.plan.keys, ","));
  for (const VariableConvergence& v : c.variables) out += fmt::format(",{} [{}]", v.name, v.units);
  for (std::size_t i = 0; i < error_count(c); ++i) {
    out += fmt::format("\n{},{}", fmt::join(c.levels[i].sizes, ","), c.levels[i].steps);
    for (const VariableConvergence& v : c.variables) out += fmt::format(",{}", v.differences[i]);
  }
  return out + "\n";
}

void write_convergence(const std::filesystem::path& folder, const Convergence& c) {
  write_text(folder / "convergence.csv", to_csv(c));
  write_text(folder / "convergence.json", to_json(c));
}

namespace {

namespace fs = std::filesystem;

/// The inputs of a study. The reference is one of them, so that the study cannot overwrite it.
std::vector<std::string> inputs_of(const ConvergencePlace& place, const ConvergenceStart& start) {
  std::vector<std::string> inputs = start.files;
  if (!place.reference.empty())
    inputs.push_back(fs::is_directory(place.reference) ? fs::path(place.reference) / "summary.json"
                                                       : fs::path(place.reference));
  return inputs;
}

}  // namespace

Convergence converge_into(const ConvergencePlace& place, const ConvergencePlan& plan,
                          const ConvergenceOptions& options) {
  const ConvergenceStart start = check(plan);
  const OutputFolder folder =
      prepare(place.folder, place.overwrite, inputs_of(place, start), ResultKind::convergence);
  try {
    Convergence c = converge(plan, options);
    write_convergence(folder.path, c);
    return c;
  } catch (const RunError& e) {
    write_text(folder.failure(), fmt::format("{}\n", e.what()));
    throw;
  }
}

}  // namespace tdbd::simulation

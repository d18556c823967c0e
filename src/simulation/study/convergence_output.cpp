#include "simulation/study/convergence_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/whole_file.hpp"
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
          {"in_words", in_words(v.order, errors)}};
}

Json levels_json(const Convergence& c) {
  Json levels = Json::array();
  for (const ConvergenceLevel& level : c.levels) {
    Json state = Json::object();
    for (const StateVariable& v : level.end.variables) state[v.name] = v.values;
    levels.push_back({{"size", level.size}, {"steps", level.steps}, {"state", state}});
  }
  return levels;
}

std::size_t error_count(const Convergence& c) {
  return c.variables.empty() ? 0 : c.variables.front().differences.size();
}

/// Of the quantity that is divided, in brackets. Only the step's is known here: SI is what is left.
std::string unit_text(const ConvergencePlan& plan) {
  return plan.key == "time.step" ? "[s]" : "[SI]";
}

}  // namespace

std::string table_text(const Convergence& c) {
  const std::string errors = error_name(c.plan);
  std::string out = fmt::format("{} of {} divided by {:g} over {} levels, {} {}\n", c.plan.key,
                                c.plan.case_file, c.plan.factor, c.levels.size(), errors,
                                c.plan.reference ? "against the reference" : "to the next level");
  const auto add = [&out]<class... T>(fmt::format_string<T...> text, T&&... values) {
    fmt::format_to(std::back_inserter(out), text, std::forward<T>(values)...);
  };
  const std::size_t first = std::max<std::size_t>(12, c.plan.key.size());
  add("{:>{}} {:>10}", c.plan.key, first, "steps");
  for (const VariableConvergence& v : c.variables) add(" {:>18}", v.name);
  add("\n{:>{}} {:>10}", unit_text(c.plan), first, "");
  for (const VariableConvergence& v : c.variables) add(" {:>18}", fmt::format("[{}]", v.units));
  for (std::size_t i = 0; i < c.levels.size(); ++i) {
    add("\n{:>{}.6g} {:>10}", c.levels[i].size, first, c.levels[i].steps);
    for (const VariableConvergence& v : c.variables)
      if (i < v.differences.size()) add(" {:>18.4e}", v.differences[i]);
  }
  out += "\nobserved orders\n";
  for (const VariableConvergence& v : c.variables)
    add("  {:<30} {}\n", v.name, in_words(v.order, errors));
  return out;
}

std::string to_json(const Convergence& c) {
  const std::string errors = error_name(c.plan);
  Json json = summary_head("converge", c.title, c.status, c.case_hash, 0);
  Json variables = Json::object();
  for (const VariableConvergence& v : c.variables) variables[v.name] = variable_json(v, errors);
  json.update(Json{{"over", c.plan.key},
                   {"factor", c.plan.factor},
                   {"against", c.plan.reference ? "reference" : "next level"},
                   {"nominal_order", c.nominal_order > 0.0 ? Json(c.nominal_order) : Json(nullptr)},
                   {"floor", order_floor},
                   {"floor_per_step", order_rounding_per_step},
                   {"exact_below_floor_times", order_exact},
                   {"settled_within", order_settled},
                   {"levels", levels_json(c)},
                   {"variables", variables}});
  return json.dump(2) + "\n";
}

std::string to_csv(const Convergence& c) {
  std::string out = fmt::format("{},steps", c.plan.key);
  for (const VariableConvergence& v : c.variables) out += fmt::format(",{} [{}]", v.name, v.units);
  for (std::size_t i = 0; i < error_count(c); ++i) {
    out += fmt::format("\n{},{}", c.levels[i].size, c.levels[i].steps);
    for (const VariableConvergence& v : c.variables) out += fmt::format(",{}", v.differences[i]);
  }
  return out + "\n";
}

void write_convergence(const std::filesystem::path& folder, const Convergence& c) {
  write_text(folder / "convergence.csv", to_csv(c));
  write_text(folder / "convergence.json", to_json(c));
}

}  // namespace tdbd::simulation

#include "reference/literature/roller/teeth/tooth_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

double in_table(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at >= x.back()) return y.back();
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

double slope_in_table(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at >= x.back()) return 0.0;
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto i = static_cast<std::size_t>(above - x.begin());
  return (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
}

struct RowFault {
  std::string column, found, expected;
};

void throw_row(const ToothTable& t, std::size_t row, std::string_view model,
               const RowFault& fault) {
  const std::string where = row < t.lines.size() ? fmt::format("{}:{}", t.source, t.lines[row])
                                                 : fmt::format("{}: row {}", t.source, row + 1);
  throw InputError(fmt::format("{}: {}: {}: found {}, expected {}", model, where, fault.column,
                               fault.found, fault.expected));
}

void check_rows(const ToothTable& t, std::string_view model) {
  if (t.depth.size() < 2 || t.force.size() != t.depth.size() || t.radius.size() != t.depth.size())
    throw InputError(
        fmt::format("{}: {}: found {} depths, {} forces and {} radii, expected two rows or more",
                    model, t.source, t.depth.size(), t.force.size(), t.radius.size()));
  struct Rising {
    const char* name;
    const std::vector<double>& values;
    bool strictly;
  };
  for (const Rising& c : {Rising{"depth", t.depth, true}, Rising{"force", t.force, false},
                          Rising{"crater_radius", t.radius, false}}) {
    if (c.values[0] != 0.0)
      throw_row(t, 0, model, {c.name, fmt::format("{}", c.values[0]), "0: the tooth touches"});
    for (std::size_t i = 1; i < c.values.size(); ++i) {
      const double step = c.values[i] - c.values[i - 1];
      if (!(std::isfinite(step) && (c.strictly ? step > 0.0 : step >= 0.0)))
        throw_row(t, i, model,
                  {c.name, fmt::format("{} after {}", c.values[i], c.values[i - 1]),
                   c.strictly ? "depths that rise" : "a monotone table"});
    }
  }
  if (t.force.back() == 0.0)
    throw_row(t, t.force.size() - 1, model, {"force", "0", "a force at the last depth"});
}

}  // namespace

double tooth_force(const ToothLaw& law, double depth) {
  if (depth <= 0.0) return 0.0;
  if (const auto* table = std::get_if<ToothTable>(&law))
    return in_table(table->depth, table->force, depth);
  const auto& power = std::get<PowerTooth>(law);
  if (power.exponent == 1.5) return power.factor * depth * std::sqrt(depth);
  return power.factor * std::pow(depth, power.exponent);
}

double tooth_stiffness(const ToothLaw& law, double depth) {
  if (depth <= 0.0) return 0.0;
  if (const auto* table = std::get_if<ToothTable>(&law))
    return slope_in_table(table->depth, table->force, depth);
  const auto& power = std::get<PowerTooth>(law);
  if (power.exponent == 1.5) return 1.5 * power.factor * std::sqrt(depth);
  return power.exponent * power.factor * std::pow(depth, power.exponent - 1.0);
}

double crater_radius(const ToothLaw& law, double depth) {
  if (depth <= 0.0) return 0.0;
  if (const auto* table = std::get_if<ToothTable>(&law))
    return in_table(table->depth, table->radius, depth);
  const double a = std::get<PowerTooth>(law).sphere_radius;
  return depth >= a ? a : std::sqrt(depth * (2.0 * a - depth));
}

double deepest_known(const ToothLaw& law) {
  const auto* table = std::get_if<ToothTable>(&law);
  return table ? table->depth.back() : std::numeric_limits<double>::infinity();
}

void check_tooth_law(const ToothLaw& law, std::string_view model) {
  if (const auto* table = std::get_if<ToothTable>(&law)) return check_rows(*table, model);
  const auto& p = std::get<PowerTooth>(law);
  for (const auto& [name, value] :
       {std::pair{"factor", p.factor}, std::pair{"exponent", p.exponent},
        std::pair{"sphere_radius", p.sphere_radius}})
    if (!(value > 0.0 && std::isfinite(value)))
      throw InputError(fmt::format("{}: the law's {}: found {}, expected a positive number", model,
                                   name, value));
}

}  // namespace tdbd::reference

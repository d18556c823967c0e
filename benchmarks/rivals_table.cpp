#include "benchmarks/rivals_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tdbd::bench {
namespace {

using Json = nlohmann::ordered_json;

Json scaled(const std::optional<double>& value, double scale) {
  return value ? Json(*value * scale) : Json();
}

Json contender_row_json(const Contender& c, const Figures& f, const Figures& z_map) {
  Json row{{"name", c.name},
           {"what", c.what},
           {"us", 1e6 * f.typical},
           {"mean_us", 1e6 * f.mean},
           {"p99_us", 1e6 * f.percentile_99},
           {"over_z_map", f.typical / z_map.typical},
           {"mean_over_z_map", f.mean / z_map.mean},
           {"p99_over_z_map", f.percentile_99 / z_map.mean},
           {"million_instructions", scaled(f.instructions, 1e-6)},
           {"million_cycles", scaled(f.cycles, 1e-6)}};
  if (!c.mesh) return row;
  const MeshFigures m = c.mesh();
  row["triangles"] = m.triangles;
  row["least_quality"] = m.least_quality;
  row["one_percent_quality"] = m.one_percent_quality;
  row["maintenance_us_a_triangle"] = scaled(f.maintenance, 1e6);
  return row;
}

/// A value of a row, or a dash if it has none.
std::string cell(const Json& row, const char* key) {
  if (!row.contains(key) || row[key].is_null()) return "-";
  return fmt::format("{:.2f}", row[key].get<double>());
}

}  // namespace

Json condition_json(const Condition& condition, const std::vector<Contender>& sides,
                    const std::vector<Figures>& figures) {
  const auto z_map = std::find_if(sides.begin(), sides.end(),
                                  [](const Contender& c) { return c.name == yardstick; });
  const Figures& over = figures[static_cast<std::size_t>(z_map - sides.begin())];
  Json rows = Json::array();
  for (std::size_t i = 0; i < sides.size(); ++i)
    rows.push_back(contender_row_json(sides[i], figures[i], over));
  return {{"name", condition.name},
          {"turns", condition.turns},
          {"steps", condition.steps},
          {"rows", std::move(rows)}};
}

std::string condition_text(const Json& condition) {
  constexpr const char* format = "{:22}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8}{:>9}{:>10}{:>9}{:>12}\n";
  std::string text =
      fmt::format("\n{}: {} turns of {} steps\n\n", condition["name"].get<std::string>(),
                  condition["turns"].get<long>(), condition["steps"].get<long>());
  text += fmt::format(format, "", "us", "mean us", "p99 us", "ratio", "mean", "p99", "M instr",
                      "M cycles", "q 1 %", "us/triangle");
  for (const Json& r : condition["rows"])
    text += fmt::format(format, r["name"].get<std::string>(), cell(r, "us"), cell(r, "mean_us"),
                        cell(r, "p99_us"), cell(r, "over_z_map"), cell(r, "mean_over_z_map"),
                        cell(r, "p99_over_z_map"), cell(r, "million_instructions"),
                        cell(r, "million_cycles"), cell(r, "one_percent_quality"),
                        cell(r, "maintenance_us_a_triangle"));
  return text;
}

}  // namespace tdbd::bench

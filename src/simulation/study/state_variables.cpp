#include "simulation/study/state_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "core/error.hpp"
#include "core/read_file.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

/// Where a variable stands in a summary.
struct Entry {
  const char* key;
  const char* name;
  const char* units;
  double factor;
  double least_scale;     ///< angles count in radians however small they are
  const char* scale_key;  ///< another entry that holds the scale; null: the variable's own size
};

constexpr double per_sqrt2 = 1.0 / std::numbers::sqrt2;

constexpr Entry rotate_entries[] = {
    {"attitude", "attitude", "rad", per_sqrt2, 1.0, nullptr},
    {"body_momentum", "body_momentum", "N m s", 1.0, 0.0, nullptr},
    {"space_momentum", "space_momentum", "N m s", 1.0, 0.0, nullptr},
    {"angular_velocity", "angular_velocity", "rad/s", 1.0, 0.0, nullptr},
    {"cone_angles", "cone_angles", "rad", 1.0, 1.0, nullptr},
    {"cone_momenta", "cone_momenta", "N m s", 1.0, 0.0, nullptr},
    {"energy_end", "energy", "J", 1.0, 0.0, "energy_scale"},
};

constexpr Entry run_entries[] = {
    {"removed_volume_m3", "removed_volume", "m3", 1.0, 0.0, nullptr},
    {"removed_volume_by_part_m3", "removed_volume_by_part", "m3", 1.0, 0.0, nullptr},
    {"removed_volume_by_revolution_m3", "removed_volume_by_revolution", "m3", 1.0, 0.0, nullptr},
};

/// The numbers in a value, an array or an object, depth first.
void collect(const Json& json, std::vector<double>& values) {
  if (json.is_number()) values.push_back(json.get<double>());
  if (json.is_structured())
    for (const Json& element : json) collect(element, values);
}

StateVariable read_variable(const Json& summary, const Entry& e) {
  StateVariable v{e.name, e.units, {}, e.factor, e.least_scale};
  collect(summary.at(e.key), v.values);
  double squared = 0.0;
  for (const double x : v.values) squared += x * x;
  v.scale = std::max(v.scale, v.factor * std::sqrt(squared));
  if (e.scale_key != nullptr) v.scale = std::max(v.scale, summary.at(e.scale_key).get<double>());
  return v;
}

std::span<const Entry> entries_of(const std::string& command) {
  if (command == "rotate") return rotate_entries;
  if (command == "run") return run_entries;
  throw InputError(fmt::format("the command \"{}\"", command));
}

}  // namespace

double distance(const StateVariable& a, const StateVariable& b) {
  double squared = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    squared += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
  return a.factor * std::sqrt(squared);
}

EndState read_end_state(const std::string& text, const std::string& source) {
  EndState end;
  try {
    const Json summary = Json::parse(text);
    end.command = summary.at("command").get<std::string>();
    end.duration = summary.at("duration_s").get<double>();
    for (const Entry& e : entries_of(end.command))
      if (StateVariable v = read_variable(summary, e); !v.values.empty())
        end.variables.push_back(std::move(v));
  } catch (const std::exception& e) {
    throw InputError(fmt::format("{}: found {}, expected the summary of a run or a rotate case",
                                 source, e.what()));
  }
  return end;
}

EndState read_end_state_file(const std::filesystem::path& file_or_folder) {
  std::filesystem::path file = file_or_folder;
  if (std::filesystem::is_directory(file)) file /= "summary.json";
  return read_end_state(read_file(file, "a summary.json or the folder of a result"), file.string());
}

}  // namespace tdbd::simulation

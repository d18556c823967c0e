#include "simulation/study/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string_view>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/read_file.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

/// Which summaries of a command contain a variable.
enum class Presence { all, with_forces };

/// Location of a variable in a summary.
struct Entry {
  const char* key;  ///< may be inside an object of the summary: "diagnosis/wob_swing"
  const char* name;
  const char* units;
  double factor;
  double least_scale;               ///< lower limit of the scale; angles use 1 rad
  const char* scale_key = nullptr;  ///< key of another entry with the scale; null: own size
  Presence presence = Presence::all;
  const char* of_each = nullptr;  ///< for a list of parts: key of their entries
};

constexpr Entry force(const char* key, const char* name, const char* units) {
  return {key, name, units, 1.0, 0.0, nullptr, Presence::with_forces};
}

constexpr double per_sqrt2 = 1.0 / std::numbers::sqrt2;

/// Variables of free motion. Values small compared with `least_scale` are compared with it.
constexpr Entry diagnosed(const char* key, const char* name, const char* units,
                          double least_scale) {
  return {key, name, units, 1.0, least_scale, nullptr, Presence::with_forces};
}

/// The part of a cutter (face or chamfer) that captures a vertex depends on the time step; the
/// volume of the whole cutter does not.
constexpr const char* cutters = "removed_volume_by_cutter";

/// One value per started revolution.
constexpr std::string_view by_revolution = "removed_volume_by_revolution_m3";

constexpr Entry rotate_entries[] = {
    {"attitude", "attitude", "rad", per_sqrt2, 1.0},
    {"body_momentum", "body_momentum", "N m s", 1.0, 0.0},
    {"space_momentum", "space_momentum", "N m s", 1.0, 0.0},
    {"angular_velocity", "angular_velocity", "rad/s", 1.0, 0.0},
    {"cone_angles", "cone_angles", "rad", 1.0, 1.0},
    {"cone_momenta", "cone_momenta", "N m s", 1.0, 0.0},
    {"energy_end", "energy", "J", 1.0, 0.0, "energy_scale"},
};

constexpr Entry run_entries[] = {
    {"removed_volume_m3", "removed_volume", "m3", 1.0, 0.0},
    {"removed_volume_by_part_m3", "removed_volume_by_part", "m3", 1.0, 0.0},
    {"removed_volume_by_part_m3", cutters, "m3", 1.0, 0.0},
    {by_revolution.data(), "removed_volume_by_revolution", "m3", 1.0, 0.0},
    force("wob_mean_n", "wob_mean", "N"),
    force("tob_mean_n_m", "tob_mean", "N m"),
    force("rop_mean_m_per_s", "rop_mean", "m/s"),
    force("rotary_speed_mean_rad_per_s", "rotary_speed_mean", "rad/s"),
    force("drilling_power_mean_w", "drilling_power_mean", "W"),
    diagnosed("diagnosis/stick_slip_severity", "stick_slip_severity", "1", 1.0),
    diagnosed("diagnosis/torsional_frequency_hz", "torsional_frequency", "Hz", 0.0),
    diagnosed("diagnosis/wob_swing", "wob_swing", "1", 1.0),
    diagnosed("diagnosis/axial_frequency_hz", "axial_frequency", "Hz", 0.0),
    diagnosed("diagnosis/orbit_radius_m", "orbit_radius", "m", 1e-3),
    diagnosed("diagnosis/orbit_frequency_hz", "orbit_frequency", "Hz", 0.0),
    {"cones", "cone_speed_ratios", "1", 1.0, 0.0, nullptr, Presence::with_forces,
     "mean_speed_ratio"},
    {"forces", "normal_mean_by_part", "N", 1.0, 0.0, nullptr, Presence::with_forces,
     "normal_mean_n"},
};

/// Appends all numbers in a value, an array or an object, depth first.
void collect(const Json& json, std::vector<double>& values) {
  if (json.is_number()) values.push_back(json.get<double>());
  if (json.is_structured())
    for (const Json& element : json) collect(element, values);
}

/// Appends an entry of a list of parts for each part of the bit; 0 for parts that are not in the
/// list.
void collect_by_part(const Json& summary, const Entry& e, std::vector<double>& values) {
  std::map<std::string, double> known;
  for (const Json& part : summary.at(e.key))
    if (part.at(e.of_each).is_number())
      known[part.at("name").get<std::string>()] = part.at(e.of_each).get<double>();
  for (const auto& part : summary.at("removed_volume_by_part_m3").items())
    values.push_back(known[part.key()]);
}

/// Sums over parts whose names agree up to the first slash: those of a cutter or of a cone.
std::vector<double> by_cutter(const Json& by_part) {
  std::map<std::string, double> sums;
  for (const auto& part : by_part.items())
    sums[part.key().substr(0, part.key().find('/'))] += part.value().get<double>();
  std::vector<double> values;
  values.reserve(sums.size());
  for (const auto& [name, sum] : sums) values.push_back(sum);
  return values;
}

/// Appends an entry of every object in a list.
void collect_of_each(const Json& list, const char* key, std::vector<double>& values) {
  for (const Json& one : list) collect(one.at(key), values);
}

double size_of(const std::vector<double>& values, double factor) {
  double squared = 0.0;
  for (const double x : values) squared += x * x;
  return factor * std::sqrt(squared);
}

StateVariable read_variable(const Json& summary, const Entry& e) {
  StateVariable v{e.name, e.units, {}, e.factor, e.least_scale};
  const Json::json_pointer at(fmt::format("/{}", e.key));
  if (e.presence == Presence::with_forces && !summary.contains(at)) return v;
  if (e.name == cutters)
    v.values = by_cutter(summary.at(at));
  else if (e.of_each == nullptr)
    collect(summary.at(at), v.values);
  else if (e.key == std::string_view("cones"))
    collect_of_each(summary.at(at), e.of_each, v.values);
  else
    collect_by_part(summary, e, v.values);
  v.scale = std::max(v.scale, size_of(v.values, v.factor));
  v.grows = std::string_view(e.key) == by_revolution;
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
  const auto value = [](const StateVariable& v, std::size_t i) {
    return i < v.values.size() ? v.values[i] : 0.0;
  };
  double squared = 0.0;
  for (std::size_t i = 0; i < std::max(a.values.size(), b.values.size()); ++i)
    squared += (value(a, i) - value(b, i)) * (value(a, i) - value(b, i));
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

void add_motion(const dynamics::DrillingState& state, EndState& end) {
  const auto add = [&](const char* name, const char* units, double factor, double least_scale,
                       std::vector<double> values) {
    const double size = size_of(values, factor);
    end.variables.push_back({name, units, std::move(values), factor, std::max(least_scale, size)});
  };
  const auto list = [](const auto& x) {
    return std::vector<double>(x.data(), x.data() + x.size());
  };
  const dynamics::RotationState& turned = state.rotation;
  add("position", "m", 1.0, 0.0, list(Vec3(state.c_W - Vec3(0.0, 0.0, state.rock_z))));
  add("attitude", "rad", per_sqrt2, 1.0, list(Mat3(turned.q_WB.toRotationMatrix())));
  add("momentum", "N s", 1.0, 0.0, list(state.momentum_W));
  add("space_momentum", "N m s", 1.0, 0.0, list(turned.momentum_W));
  if (turned.cone_angles.empty()) return;
  add("cone_angles", "rad", 1.0, 1.0, turned.cone_angles);
  add("cone_momenta", "N m s", 1.0, 0.0, turned.cone_momenta);
}

EndState read_end_state_file(const std::filesystem::path& file_or_folder) {
  std::filesystem::path file = file_or_folder;
  if (std::filesystem::is_directory(file)) file /= "summary.json";
  return read_end_state(read_file(file, "a summary.json or the folder of a result"), file.string());
}

namespace {

double median_edge(const mesh::TriangleMesh& m) {
  if (m.triangles.empty()) return 0.0;
  std::vector<double> lengths;
  for (const mesh::Triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      lengths.push_back((m.positions[at(t[i])] - m.positions[at(t[(i + 1) % 3])]).norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double radius(const mesh::TriangleMesh& m) {
  mesh::Box box;
  for (const mesh::Triangle& t : m.triangles)
    for (const int v : t) box.add(m.positions[at(v)]);
  return m.triangles.empty() ? 0.0 : 0.5 * std::max(box.size().x(), box.size().y());
}

}  // namespace

Hole hole_of(const rock::Rock& rock) {
  std::vector<int> slots;
  Hole hole{mesh::compact(rock.surface, &slots), {}};
  hole.cut.positions = hole.rock.positions;
  const auto is_moved = [&](int v) { return rock.last_part[at(slots[at(v)])] >= 0; };
  std::ranges::copy_if(hole.rock.triangles, std::back_inserter(hole.cut.triangles),
                       [&](const mesh::Triangle& t) { return std::ranges::any_of(t, is_moved); });
  hole.edge = median_edge(hole.cut);
  return hole;
}

HoleDifference difference(const Hole& a, const Hole& b) {
  if (a.cut.triangles.empty() && b.cut.triangles.empty()) return {};
  const double edge =
      a.edge > 0.0 && b.edge > 0.0 ? std::min(a.edge, b.edge) : std::max(a.edge, b.edge);
  const mesh::SurfaceDistance there = distance_to(a.cut, mesh::TriangleTree(b.rock), 0.5 * edge),
                              back = distance_to(b.cut, mesh::TriangleTree(a.rock), 0.5 * edge);
  return {std::max(there.largest, back.largest), 0.5 * (there.volume + back.volume),
          std::max(radius(a.cut), radius(b.cut))};
}

namespace {

constexpr const char* this_level = "the level's summary";

LevelOutcome rotate_level(const std::string& file, const std::vector<std::string>& overrides,
                          int number, const ConvergenceOptions& o) {
  const RotateCase c = read_rotate_case(file, overrides);
  RotateOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](long done, long total) { o.progress(number, done, total); };
  RotateSimulation s = start(c);
  RotateSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  return {status,       c.time.step,
          s.steps_done, read_end_state(summary_json(c, s, status), this_level),
          {},           s.rotating.evaluations};
}

LevelOutcome drill_level(const std::string& file, const std::vector<std::string>& overrides,
                         int number, const ConvergenceOptions& o) {
  const Case c = read_case(file, overrides);
  const ThreadLimit limit(o.threads);
  RunOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](const Simulation& so_far, long total) {
      o.progress(number, so_far.state.steps_done, total);
    };
  Simulation s = start(c);
  DrillingSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  LevelOutcome level{status,
                     c.time.step,
                     s.state.steps_done,
                     read_end_state(to_json(summary_of(c, s, status)), this_level),
                     hole_of(s.state.rock),
                     0};
  if (s.state.drive) add_motion(s.state.drive->state, level.end);
  return level;
}

}  // namespace

LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& o) {
  return is_rotate_case(case_file) ? rotate_level(case_file, overrides, number, o)
                                   : drill_level(case_file, overrides, number, o);
}

}  // namespace tdbd::simulation

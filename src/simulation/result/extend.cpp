#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"
#include "io/output_folder.hpp"
#include "io/whole_file.hpp"
#include "mesh/measures.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/result/run.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/step.hpp"

namespace tdbd::simulation {
namespace {

// Bytes per item in files of TDBD (checked by `RunEstimate.is_near_what_a_run_takes`).
constexpr double frame_per_triangle = 43.0, animation_per_triangle = 20.0,
                 final_per_triangle = 25.0;
constexpr double checkpoint_per_triangle = 55.0;
constexpr double csv_per_number = 18.0, bit_level_columns = 25.0;
constexpr double numbers_per_part = 8.0, numbers_per_cutter = 10.0;

double triangles_of(const bit::Bit& bit) {
  double sum = 0.0;
  for (const bit::Part& p : bit.parts) sum += static_cast<double>(p.mesh_P.triangles.size());
  return sum;
}

double history_bytes(const Case& c, double steps) {
  const double numbers = bit_level_columns +
                         numbers_per_part * static_cast<double>(c.bit.parts.size()) +
                         numbers_per_cutter * static_cast<double>(c.bit.cutters.size());
  const double rows = steps / static_cast<double>(c.output.history_every);
  // Bytes of a number: in history.nc single values, or windows that are deflated; in history.rows.
  constexpr double whole = 8.0, window = 2.0, rows_of_chunk = 64.0;
  const bool has_windows = c.output.history_every > 1;
  const double in_nc =
      has_windows ? window * rows : whole * rows_of_chunk * std::ceil(rows / rows_of_chunk);
  const double in_rows = c.output.checkpoint_every != 0 ? whole * rows : 0.0;
  return (in_nc + in_rows) * numbers + csv_per_number * bit_level_columns * rows;
}

/// Returns the size of the profiles of a string on a chain.
double profile_bytes(const Case& c, double steps) {
  const auto& chained = c.drilling.system.chained;
  if (!chained || c.output.chain.profile_every == 0) return 0.0;
  constexpr double of_nodes = 5.0, of_elements = 2.0, deflated = 7.0;
  const double numbers = (of_nodes + of_elements) * chained->chain.count();
  return deflated * numbers * steps / static_cast<double>(c.output.chain.profile_every);
}

double disk_bytes(const Case& c, double triangles, double steps) {
  double frames = 1.0;
  if (c.output.frames_every > 0) frames += steps / static_cast<double>(c.output.frames_every);
  const double of_bit =
      frames > 1.0 ? frame_per_triangle + animation_per_triangle : frame_per_triangle;
  constexpr double two = 2.0;  // checkpoints, which are kept during the run
  return frames * frame_per_triangle * triangles + of_bit * triangles_of(c.bit) +
         final_per_triangle * triangles + two * checkpoint_per_triangle * triangles +
         history_bytes(c, steps) + profile_bytes(c, steps);
}

mesh::Box box_of(const mesh::Surface& s) {
  mesh::Box box;
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (s.is_alive(v)) box.add(s.position(v));
  return box;
}

/// Measures the run time of one step in seconds, over some tenths of a second. A step that fails
/// ends the measurement; the run itself will report the failure.
double seconds_per_step(const Case& c, Simulation& s, long& tried) {
  constexpr double enough = 0.4;  // s
  const auto began = std::chrono::steady_clock::now();
  try {
    while (s.state.steps_done < c.time.steps && seconds_since(began) < enough) {
      step(c, s);
      ++tried;
    }
  } catch (const RunError&) {
    tried = 0;
  }
  return tried > 0 ? seconds_since(began) / static_cast<double>(tried) : 0.0;
}

}  // namespace

RunEstimate estimate(const Case& c, Simulation& s) {
  RunEstimate e;
  const double steps = static_cast<double>(c.time.steps - c.time.first);
  const RockRequirements wall = new_wall_requirements(c);
  e.triangles = static_cast<double>(s.state.start_triangles) + wall.triangles;
  const RockRequirements start =
      rock_requirements(0.0, box_of(s.state.rock.surface), c.rock.edge_length);
  e.memory_bytes = bytes_of_triangles(e.triangles) + start.bytes + wall.bytes -
                   bytes_of_triangles(wall.triangles);
  e.disk_bytes = disk_bytes(c, e.triangles, steps);
  e.seconds = steps * seconds_per_step(c, s, e.steps_tried);
  return e;
}

namespace {

namespace fs = std::filesystem;

std::string_view key_of_override(const std::string& assignment) {
  return trimmed(std::string_view(assignment).substr(0, assignment.find('=')));
}

bool sets(const std::vector<std::string>& overrides, std::string_view key) {
  return std::ranges::any_of(overrides,
                             [&](const std::string& o) { return key_of_override(o) == key; });
}

void require_resumable(const fs::path& folder, const std::vector<std::string>& overrides) {
  for (const std::string& o : overrides)
    if (const std::string_view key = key_of_override(o);
        std::ranges::count(resumable_keys, key) == 0)
      throw InputError(fmt::format(
          "--set: found {} for a run that is resumed, expected one of {}; its other settings are "
          "those of {}",
          key, fmt::join(resumable_keys, ", "), (folder / "case.toml").string()));
}

/// The value of an override as TOML: a number, a text in quotes, or a bare text.
std::string toml_value(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string value(equals == std::string::npos
                              ? std::string_view()
                              : trimmed(std::string_view(assignment).substr(equals + 1)));
  const bool is_quoted = value.starts_with('"') || value.starts_with('\'');
  const bool is_number = value.find_first_not_of("+-.0123456789eE_") == std::string::npos;
  return is_quoted || (is_number && !value.empty()) ? value : "\"" + value + "\"";
}

/// The lines of a table of the resolved case that the overrides replace. A case has a duration or a
/// number of revolutions, and the one that is set replaces the other.
bool is_replaced(const std::string& table, const std::string& line,
                 const std::vector<std::string>& overrides) {
  const bool moves_end = sets(overrides, "time.duration") || sets(overrides, "time.revolutions");
  if (table == "[time]")
    return moves_end && (line.starts_with("duration =") || line.starts_with("revolutions ="));
  return table == "[output]" && sets(overrides, "output.means_from") &&
         line.starts_with("means_from =");
}

/// The resolved case with other values.
std::string with_values(const std::string& text, const std::vector<std::string>& overrides) {
  std::istringstream in(text);
  std::string changed, line, table;
  while (std::getline(in, line)) {
    if (line.starts_with('[')) table = line;
    if (!is_replaced(table, line, overrides)) changed += line + "\n";
    if (line != "[time]" && line != "[output]") continue;
    for (const std::string& o : overrides) {
      const std::string_view key = key_of_override(o);
      const std::size_t dot = key.find('.');
      if (table == fmt::format("[{}]", key.substr(0, dot)))
        changed += fmt::format("{} = {}\n", key.substr(dot + 1), toml_value(o));
    }
  }
  return changed;
}

Case longer_case(const fs::path& file, const std::vector<std::string>& overrides) {
  const std::string text = with_values(read_file(file, "a TOML file"), overrides);
  return read_case(Config::read_text(text, file.string()), file.string());
}

/// Reads a checkpoint of the new case, if an earlier call wrote one, or of the case before.
Checkpoint read_either(const fs::path& file, const Case& longer, const Case& before) {
  try {
    return read_checkpoint(file, longer);
  } catch (const InputError&) {
    return read_checkpoint(file, before);
  }
}

/// Means from a later time on begin again; the sums over steps cannot be divided.
void move_means(const Case& longer, const Case& before, Checkpoint& saved) {
  const double from = longer.output.means_from;
  if (from == before.output.means_from) return;
  const double done = time_at(longer.time, saved.steps_done() - longer.time.first);
  if (done > from)
    throw InputError(fmt::format(
        "--set: output.means_from: found {:.6g} s, expected {:.6g} s, from which the run has its "
        "means, or at least the {:.6g} s that it has made",
        from, before.output.means_from, done));
  const Statistics fresh = start_statistics(longer);
  saved.statistics.loads = fresh.loads;
  saved.statistics.trace = fresh.trace;
}

void require_later_end(const Case& longer, const Case& before, const Checkpoint& saved) {
  const long least = saved.steps_done();
  if (longer.time.steps >= least && longer.time.step == before.time.step &&
      (longer.time.steps > least || least < before.time.steps))
    return;
  throw InputError(fmt::format(
      "--set: found an end after {:.6g} s, expected one after the {:.6g} s that the run has made",
      time_at(longer.time, longer.time.steps), time_at(before.time, least)));
}

}  // namespace

Case extend_run(const fs::path& path, const std::vector<std::string>& overrides,
                const CheckpointKeeper::Warn& warn) {
  require_resumable(path, overrides);
  const fs::path file = stopped_case(path, Stopped::run);
  const Case before = read_case(file.string(), {});
  Case longer = longer_case(file, overrides);
  const OutputFolder folder{path, std::make_shared<FolderLock>(path)};
  std::optional<Checkpoint> saved;
  const auto read = [&](const fs::path& checkpoint) {
    return saved.emplace(read_either(checkpoint, longer, before)).steps_done();
  };
  if (!read_newest_checkpoint(folder, read, warn) && tidy_if_finished(path))
    throw InputError(
        fmt::format("{}: found a complete run without a checkpoint (output.checkpoint_every = 0), "
                    "expected one from which to continue; run the case again with the later end",
                    path.string()));
  if (saved) {
    require_later_end(longer, before, *saved);
    move_means(longer, before, *saved);
    // Why an order was not observed is stated for the new number of steps.
    if (saved->written.order.window == 0.0) saved->written.order = {};
    // The tables of the surface are rebuilt by the reader of a checkpoint and are not stored.
    tdbd::write_checkpoint(folder.new_checkpoint(), {longer.hash, longer.resolved}, saved->state,
                           saved->statistics, saved->written);
    fs::rename(folder.new_checkpoint(), folder.checkpoint());
  }
  write_text(file, std::string(resolved_head) + "\n" + longer.resolved);
  forget_end(folder);
  return longer;
}

}  // namespace tdbd::simulation

#include "simulation/result/extend.hpp"

#include <fmt/format.h>

#include <algorithm>
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
#include "simulation/result/recorder.hpp"
#include "simulation/result/run.hpp"

namespace tdbd::simulation {
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

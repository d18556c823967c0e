
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "simulation/case/string_settings.hpp"
#include "simulation/case/top_settings.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::Schedule;
using string::Top;

/// Checks that times ascend. The message names the line of the file.
void demand_ascending(const FieldTable& t, const std::string& column,
                      const std::vector<double>& times) {
  CsvMistakes mistakes{t.file};
  for (std::size_t i = 1; i < times.size() && mistakes.lines.empty(); ++i)
    if (!(times[i] > times[i - 1]))
      mistakes.add(t.rows[i].line, column,
                   fmt::format("{:.6g} s after {:.6g} s", times[i], times[i - 1]),
                   "ascending times");
  mistakes.throw_if_any();
}

void demand_range(const FieldTable& t, const std::string& column, const QuantityKey& key,
                  const std::vector<double>& values) {
  CsvMistakes mistakes{t.file};
  for (std::size_t i = 0; i < values.size() && mistakes.lines.empty(); ++i)
    if (!key.range.contains(values[i]))
      mistakes.add(t.rows[i].line, column, fmt::format("{:.6g} {}", values[i], key.unit),
                   fmt::format("a value{}", key.range.text()));
  mistakes.throw_if_any();
}

/// Records settings that contradict each other: the log, and the way in which the top moves.
void check_columns(Config& c, const LogSettings& log, Top::Axial axial) {
  if (!log.rotary_speed && !log.block_speed && !log.hook_load)
    c.problem("file", "a log without a column to use",
              "rotary_speed, block_speed or hook_load: the name of a column");
  if (log.block_speed && log.hook_load)
    return c.problem("block_speed", "hook_load as well", "one of the two");
  if (log.block_speed && axial != Top::Axial::rate)
    c.problem("block_speed", "a speed of the block without string.top.axial = \"rate\"",
              "none, or that key");
  if (log.hook_load && axial != Top::Axial::hook_load)
    c.problem("hook_load", "a hook load without string.top.axial = \"hook-load\"",
              "none, or that key");
}

/// Returns the schedules of a log. At t = 0 its time is that of the first row by default.
RigLog schedules_of(Config& c, const LogSettings& log) {
  const FieldTable t = read_field_table(log.file);
  std::vector<double> times = field_column(t, log.time, "s");
  demand_ascending(t, log.time, times);
  LogStart from{times.front()};
  read_fields(c, from);
  if (from.start < times.front() || from.start > times.back())
    c.problem("start", fmt::format("{:.6g} s", from.start),
              fmt::format("a time of the log, {:.6g} to {:.6g} s", times.front(), times.back()));
  for (double& x : times) x -= from.start;
  const auto read = [&](const std::optional<std::string>& column, const QuantityKey& key) {
    if (!column) return Schedule{};
    std::vector<double> values = field_column(t, *column, std::string(key.unit));
    demand_range(t, *column, key, values);
    return dynamics::make_schedule(dynamics::Interpolation::linear, times, std::move(values));
  };
  return {read(log.rotary_speed, motion_keys::rotary_speed),
          read(log.block_speed, motion_keys::rate_of_penetration),
          read(log.hook_load, top_keys::hook_load), times.back()};
}

double over_step(const Schedule& s, double t, double h) {
  return dynamics::integral_to(s, t + h) - dynamics::integral_to(s, t);
}

}  // namespace

RigLog read_rig_log(Config& whole) {
  Config string = whole.table(ChainSettings::table);
  Config top = string.table(TopSettings::table);
  if (!top.has(LogSettings::table)) return {};
  const std::size_t mistakes = whole.problem_count();
  const auto settings = read_table<LogSettings>(top);
  Config c = top.table(LogSettings::table);
  if (read_string_model(string) != StringModel::chain)
    c.problem("file", "a log of the rig without string.model = \"chain\"", "none, or that model");
  FieldReader reader(top);
  TopSettings drive;
  drive.visit_axial(reader);
  check_columns(c, settings, drive.top.axial);
  RigLog log;
  try {
    if (whole.problem_count() == mistakes) log = schedules_of(c, settings);
  } catch (const InputError& e) {
    whole.other_file(e.what());
  }
  LogStart unused;
  if (c.has("start") && whole.problem_count() != mistakes) read_fields(c, unused);
  return log;
}

void check_rig_log(Config& whole, const RigLog& log, double duration) {
  constexpr double rounding = 1e-9;
  if (duration <= log.end * (1.0 + rounding)) return;
  whole.table(ChainSettings::table)
      .table(TopSettings::table)
      .table(LogSettings::table)
      .problem("file", fmt::format("{:.6g} s of a log for a run of {:.6g} s", log.end, duration),
               "a log that lasts as long as the run");
}

void refuse_logged(Config& table, const QuantityKey& key, const Schedule& logged) {
  if (!is_given(logged) || !table.has(key)) return;
  table.problem(key, "a value in addition to that of the log",
                "one of the two: see [string.top.log]");
}

string::TopCommand command_of(const RigLog& log, const string::TopCommand& usual, double t,
                              double h) {
  string::TopCommand c = usual;
  if (is_given(log.rotary_speed)) c.turn = over_step(log.rotary_speed, t, h);
  if (is_given(log.block_speed)) c.way = over_step(log.block_speed, t, h);
  if (is_given(log.hook_load)) c.hook_load = over_step(log.hook_load, t, h) / h;
  return c;
}

}  // namespace tdbd::simulation

#include "simulation/case/rig_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/config/field_table.hpp"
#include "core/error.hpp"
#include "simulation/case/chain_keys.hpp"
#include "simulation/case/rig_log_keys.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::Schedule;
using string::Top;

/// Times ascend; named by the line of the file.
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

/// The names of columns that a case gives; empty: not this one.
struct LogColumns {
  std::string time, rotary_speed, block_speed, hook_load;
};

LogColumns read_log_columns(Config& c) {
  using namespace rig_log_keys;
  const auto optional = [&](const TextKey& key) { return c.has(key) ? c.read(key) : ""; };
  return {c.read(time), optional(rotary_speed), optional(block_speed), optional(hook_load)};
}

/// What cannot be beside each other: the log, and the way in which the top moves.
void check_columns(Config& c, const LogColumns& columns, Top::Axial axial) {
  using namespace rig_log_keys;
  if (columns.rotary_speed.empty() && columns.block_speed.empty() && columns.hook_load.empty())
    c.problem(file, "a log without a column to use",
              "rotary_speed, block_speed or hook_load: the name of a column");
  if (!columns.block_speed.empty() && !columns.hook_load.empty())
    return c.problem(block_speed, "hook_load as well", "one of the two");
  if (!columns.block_speed.empty() && axial != Top::Axial::rate)
    c.problem(block_speed, "a speed of the block without string.top.axial = \"rate\"",
              "none, or that key");
  if (!columns.hook_load.empty() && axial != Top::Axial::hook_load)
    c.problem(hook_load, "a hook load without string.top.axial = \"hook-load\"",
              "none, or that key");
}

/// The schedules of a log; `start`: its time at t = 0, s, that of the first row unless given.
RigLog schedules_of(Config& c, const std::string& file, const LogColumns& columns) {
  const FieldTable t = read_field_table(file);
  std::vector<double> times = field_column(t, columns.time, "s");
  demand_ascending(t, columns.time, times);
  const double start = c.read(rig_log_keys::start, times.front());
  if (start < times.front() || start > times.back())
    c.problem(rig_log_keys::start, fmt::format("{:.6g} s", start),
              fmt::format("a time of the log, {:.6g} to {:.6g} s", times.front(), times.back()));
  for (double& x : times) x -= start;
  const auto read = [&](const std::string& column, const QuantityKey& key) {
    if (column.empty()) return Schedule{};
    std::vector<double> values = field_column(t, column, std::string(key.unit));
    demand_range(t, column, key, values);
    return dynamics::make_schedule(dynamics::Interpolation::linear, times, std::move(values));
  };
  return {read(columns.rotary_speed, motion_keys::rotary_speed),
          read(columns.block_speed, motion_keys::rate_of_penetration),
          read(columns.hook_load, top_keys::hook_load), times.back()};
}

double over_step(const Schedule& s, double t, double h) {
  return dynamics::integral_to(s, t + h) - dynamics::integral_to(s, t);
}

}  // namespace

RigLog read_rig_log(Config& whole) {
  Config string = whole.table(chain_keys::table);
  Config top = string.table(top_keys::table);
  if (!top.has(rig_log_keys::table)) return {};
  Config c = top.table(rig_log_keys::table);
  const std::size_t mistakes = whole.problem_count();
  const std::string file = c.read(rig_log_keys::file);
  const LogColumns columns = read_log_columns(c);
  if (string.read(chain_keys::model) != StringModel::chain)
    c.problem(rig_log_keys::file, "a log of the rig without string.model = \"chain\"",
              "none, or that model");
  check_columns(c, columns, top.read(top_keys::axial));
  RigLog log;
  try {
    if (whole.problem_count() == mistakes) log = schedules_of(c, file, columns);
  } catch (const InputError& e) {
    whole.other_file(e.what());
  }
  if (c.has(rig_log_keys::start) && whole.problem_count() != mistakes)
    c.read(rig_log_keys::start, 0.0);
  return log;
}

void check_rig_log(Config& whole, const RigLog& log, double duration) {
  constexpr double rounding = 1e-9;
  if (duration <= log.end * (1.0 + rounding)) return;
  whole.table(chain_keys::table)
      .table(top_keys::table)
      .table(rig_log_keys::table)
      .problem(rig_log_keys::file,
               fmt::format("{:.6g} s of a log for a run of {:.6g} s", log.end, duration),
               "a log that lasts as long as the run");
}

void refuse_logged(Config& table, const QuantityKey& key, const Schedule& logged) {
  if (!is_given(logged) || !table.has(key)) return;
  table.read(key);
  table.problem(key, "a value beside that of the log", "one of the two: see [string.top.log]");
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

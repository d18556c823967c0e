#include "calibration/case/calibration_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "calibration/case/case_checks.hpp"
#include "calibration/case/read_setup.hpp"
#include "calibration/case/read_unknowns.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "simulation/case/case_spalling.hpp"
#include "simulation/case/spalling_keys.hpp"

namespace tdbd::calibration {
namespace {

using namespace calibration_keys;

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Intervals read_intervals(Config c) {
  return {.level = c.read(level),
          .bootstrap = c.read(bootstrap),
          .seed = static_cast<std::uint64_t>(c.read(seed))};
}

/// Returns the records. If the file contains mistakes, adds them to those of the case and returns
/// none.
Records read_records_of(Config& c, const std::string& file) {
  try {
    if (!file.empty()) return read_records(file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
  return {};
}

/// Records a mistake if no rock breaks out at the pressure of a record, because cut runs serve
/// every pressure.
void require_low_pressure(Config& table, double most, const CalibrationCase& c) {
  for (const Record& r : c.records.rows) {
    forces::BottomHole hole = c.rock.around;
    hole.pressure = r.pressure;
    const double confining =
        forces::confining_pressure(hole, c.rock.confinement, c.rock.materials.at(r.rock).porosity);
    if (confining > most)
      return table.problem(simulation::spalling_keys::up_to_pressure,
                           fmt::format("{:g} Pa and a record of {} in rock confined by {:g} Pa",
                                       most, r.tool, confining),
                           "records at which rock breaks out, or no table [spalling]");
  }
}

/// Reads the rule by which rock breaks out beside the faces of bits, and checks the pressures of
/// the records.
std::optional<rock::BreakoutRule> read_breakout(Config& c, const CalibrationCase& result) {
  if (!c.has(simulation::spalling_keys::table)) return std::nullopt;
  Config table = c.table(simulation::spalling_keys::table);
  const rock::BreakoutRule rule = simulation::read_breakout_rule(table);
  const double most = table.read(simulation::spalling_keys::up_to_pressure);
  if (c.problem_count() == 0) require_low_pressure(table, most, result);
  return simulation::breaks_out(rule) ? std::optional(rule) : std::nullopt;
}

}  // namespace

forces::Strength strength_of(const TestRock& rock, const Record& record) {
  forces::BottomHole hole = rock.around;
  hole.pressure = record.pressure;
  return forces::strength_of(rock.materials.at(record.rock), hole, rock.confinement);
}

const Tool& tool_named(const CalibrationCase& c, const std::string& name) {
  return *std::ranges::find(c.tools, name, &Tool::name);
}

std::vector<Record> records_of(const CalibrationCase& c, const std::vector<std::string>& names) {
  std::vector<Record> chosen;
  for (const Record& r : c.records.rows)
    if (std::ranges::find(names, r.tool) != names.end()) chosen.push_back(r);
  return chosen;
}

CalibrationCase read_calibration(const std::string& path,
                                 const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  CalibrationCase result;
  result.path = path;
  Config top = c.table(table);
  const std::string name = top.read(calibration_keys::law);
  c.stop_at_problems();  // without a law, coefficients are meaningless
  result.law = forces::law_named(name);
  const std::string file = top.read(calibration_keys::records);
  result.fit = top.read(fit_bits, std::vector<std::string>{});
  result.predict = top.read(predict_bits, std::vector<std::string>{});
  const auto out = top.read(leave_out, std::vector<std::string>{});
  result.pressures = top.read(pressures);
  result.tools = read_tools(c);
  result.unknowns = read_unknowns(c, result.law);
  result.areas = read_area_laws(c, result.law, result.tools, AreaValues::fitted, result.unknowns);
  result.rock = read_test_rock(c);
  result.grid = read_grid(c);
  result.noise = read_noise(c.table(noise));
  result.intervals = read_intervals(c.table(intervals));
  result.records = read_records_of(c, file);
  check_names(top, result);
  choose_records(top, out, result);
  result.grid.breakout = read_breakout(c, result);
  c.finish();
  check_calibration(result);
  result.files = c.files();
  result.resolved = c.resolved();
  result.hash = fnv1a_hex(c.fingerprint());
  result.records_hash = fnv1a_hex(bytes_of(file));
  return result;
}

}  // namespace tdbd::calibration

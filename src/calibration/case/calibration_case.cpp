#include "calibration/case/calibration_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "calibration/case/case_checks.hpp"
#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"

namespace tdbd::calibration {
namespace {

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
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
      return table.problem("up_to_pressure",
                           fmt::format("{:g} Pa and a record of {} in rock confined by {:g} Pa",
                                       most, r.tool, confining),
                           "records at which rock breaks out, or no table [spalling]");
  }
}

/// Reads the rule by which rock breaks out beside the faces of bits, and checks the pressures of
/// the records.
std::optional<rock::BreakoutRule> read_breakout(Config& c, const CalibrationCase& result) {
  if (!c.has(simulation::BreakoutSettings::table)) return std::nullopt;
  Config table = c.table(simulation::BreakoutSettings::table);
  const simulation::BreakoutSettings s = simulation::read_breakout_rule(table);
  if (c.problem_count() == 0) require_low_pressure(table, s.up_to_pressure, result);
  return simulation::breaks_out(s.rule) ? std::optional(s.rule) : std::nullopt;
}

/// `tdbd keys` lists what a table [bits] or [fixed] may have.
struct AnyBit {
  static constexpr TableKey table{"bits", "NAME = \"file\": the bits of the records"};
  void visit(FieldVisitor& v) {
    v.any({.name = "NAME",
           .kind = "file",
           .computed_default = "no such bit",
           .meaning = "the bit file of the bit that records call NAME"});
  }
};
struct AnyCoefficient {
  static constexpr TableKey table{"fixed", "KEY = value: coefficients that are not fitted"};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "that of the coefficient",
           .computed_default = "the coefficient's, or fitted",
           .meaning = "a coefficient of the law, as in [forces]"});
  }
};
struct AnyAreaCoefficient {
  static constexpr TableKey table{"areas.NAME.fixed",
                                  "KEY = value: coefficients of the area that are not fitted"};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "that of the coefficient",
           .computed_default = "that of the parts in no area, or fitted",
           .meaning = "a coefficient of the law, as in [forces]"});
  }
};

/// What cut runs have in [rock].
struct RockOfCuts {
  static constexpr TableKey table{"rock", "the rock, and its mesh in the cut runs"};
  CutGrid grid;
  simulation::Surroundings around;
  void visit(FieldVisitor& v) {
    grid.visit_rock(v);
    around.visit_without_mud(v);
  }
};

static constexpr TableKey rocks_table{
    "rocks.NAME", "a rock by its numbers, for records that name it (column rock)"};
static constexpr TableKey areas_table{
    "areas.NAME",
    "parts of the bits that meet all criteria and have coefficients of their own; of several areas "
    "the one with the most specific criterion decides each coefficient"};
static constexpr TableKey area_unknowns_table{"areas.NAME.unknowns.KEY",
                                              "a coefficient of the area that is fitted"};

}  // namespace

std::vector<Tool> read_tools(Config& c) {
  std::vector<Tool> tools;
  Config given_bits = c.table("bits"), given_cutters = c.table("cutters");
  static const std::regex plain("[A-Za-z0-9_-]+");
  const auto check_name = [](Config& table, const std::string& name) {
    if (!std::regex_match(name, plain))
      table.problem("", fmt::format("the name '{}'", name), "letters, digits, - and _");
  };
  for (const std::string& name : given_bits.given()) {
    check_name(given_bits, name);
    tools.push_back({name, ToolKind::bit, given_bits.path(name, std::nullopt), {}});
  }
  for (const std::string& name : given_cutters.given()) {
    check_name(given_cutters, name);
    Config table = given_cutters.table(name);
    tools.push_back({name, ToolKind::cutter, "", {}});
    read_fields(table, tools.back().cutter);
  }
  return tools;
}

TestRock read_test_rock(Config& c) {
  TestRock r;
  Config table = c.table(simulation::RockStart::table);
  FieldReader reader(table);
  simulation::Surroundings around;
  around.visit_without_mud(reader);
  r.around = around.hole;
  r.confinement = around.confinement;
  r.materials[""] = simulation::read_material(table);
  Config others = c.table("rocks");
  for (const std::string& name : others.given()) {
    Config other = others.table(name);
    simulation::RockByNumbers rock;
    read_fields(other, rock);
    r.materials[name] = rock.material;
  }
  return r;
}

CutGrid read_grid(Config& c) {
  auto grid = read_table<CutGrid>(c);
  Config rock = c.table(simulation::RockStart::table);
  FieldReader reader(rock);
  grid.visit_rock(reader);
  return grid;
}

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

std::vector<KeyTable> calibration_tables() {
  const std::string command = "calibrate";
  using bit::CutterAreaSelector;
  using simulation::BreakoutSettings;
  using simulation::NamedRock;
  using simulation::RockByNumbers;
  return {table_of<CalibrationSettings>(command, CalibrationSettings::table),
          table_of<AnyBit>(command, AnyBit::table),
          table_of<SingleCutter>(command, SingleCutter::table),
          table_of<NamedRock, RockOfCuts>(command, RockOfCuts::table),
          table_of<RockByNumbers>(command, rocks_table),
          table_of<CutGrid>(command, CutGrid::table),
          table_of<BreakoutSettings>(command, BreakoutSettings::table),
          table_of<Noise>(command, Noise::table),
          table_of<UnknownSettings>(command, UnknownSettings::table),
          table_of<AnyCoefficient>(command, AnyCoefficient::table),
          table_of<CutterAreaSelector>(command, areas_table),
          table_of<UnknownSettings>(command, area_unknowns_table),
          table_of<AnyAreaCoefficient>(command, AnyAreaCoefficient::table),
          table_of<Intervals>(command, Intervals::table)};
}

CalibrationCase read_calibration(const std::string& path,
                                 const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  CalibrationCase result;
  result.path = path;
  Config top = c.table(CalibrationSettings::table);
  CalibrationSettings settings;
  FieldReader reader(top);
  settings.visit_law(reader);
  c.stop_at_problems();  // without a law, coefficients are meaningless
  settings.visit(reader);
  result.law = forces::law_named(settings.law);
  result.fit = settings.fit_bits;
  result.predict = settings.predict_bits;
  result.pressures = settings.pressures;
  result.loss = settings.loss;
  result.tools = read_tools(c);
  result.unknowns = read_unknowns(c, result.law);
  result.areas = read_area_laws(c, result.law, result.tools, AreaValues::fitted, result.unknowns);
  result.rock = read_test_rock(c);
  result.grid = read_grid(c);
  result.noise = read_table<Noise>(c);
  result.intervals = read_table<Intervals>(c);
  result.records = read_records_of(c, settings.records);
  check_names(top, result);
  choose_records(top, settings.leave_out, result);
  result.grid.breakout = read_breakout(c, result);
  c.finish();
  check_calibration(result);
  result.files = c.files();
  result.resolved = c.resolved();
  result.hash = fnv1a_hex(c.fingerprint());
  result.doubts = result.records.doubts;
  for (const ConfigDoubt& d : c.doubts()) result.doubts.push_back(d.place + ": " + d.text);
  result.records_hash = fnv1a_hex(bytes_of(settings.records));
  return result;
}

}  // namespace tdbd::calibration

#include "simulation/case/case_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bit/areas/area_rules.hpp"
#include "bit/files/bit_file.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/read_chain.hpp"
#include "simulation/case/rotate_settings.hpp"

namespace tdbd::simulation {
namespace {

/// The table by which a kind of file is recognized, and its name.
struct Sign {
  CaseKind kind;
  const char* table;  ///< a table that no other kind has
  const char* name;
  const char* command;
};

constexpr Sign signs[] = {
    {CaseKind::rotation, "body", "a body to rotate", "rotate"},
    {CaseKind::calibration, "calibration", "a calibration", "calibrate"},
    {CaseKind::sweep, "sweep", "a sweep's design", "sweep"},
    {CaseKind::laboratory, "laboratory", "a synthetic laboratory", "laboratory"},
    {CaseKind::string, "string.sections", "a drill string", "string"},
    {CaseKind::string, "string.model", "a drill string", "string"},
    {CaseKind::drilling, "motion", "a case to drill", "run"},
    {CaseKind::bit, "cutters", "a bit", "bit"},
    {CaseKind::bit, "design", "a bit", "bit"},
    {CaseKind::bit, "journal", "a bit", "bit"},
    {CaseKind::bit, "solids", "a bit", "bit"},
};

const Sign& sign_of(CaseKind kind) { return *std::ranges::find(signs, kind, &Sign::kind); }

/// Names the kinds of part on which a coefficient acts, unless these are all that its law knows.
std::string where_it_acts(const forces::Law& law, const forces::LawField& field) {
  std::string kinds;
  bool on_all = true;
  for (const bit::PartKind kind : bit::part_kinds) {
    if (forces::acts_on(field, kind))
      kinds += fmt::format("{}{}", kinds.empty() ? "; acts on: " : ", ", bit::kind_words(kind));
    else if (forces::knows(law, kind))
      on_all = false;
  }
  return on_all ? "" : kinds;
}

/// Lists the coefficients of every law that has any.
std::vector<KeyTable> law_tables() {
  std::vector<KeyTable> tables;
  for (const std::string_view name : forces::law_names()) {
    forces::Law each = forces::law_named(name);
    std::vector<KeyRow> fields;
    for (const forces::LawField& field : forces::law_fields(each)) {
      fields.push_back(row(key_of(field)));
      fields.back().meaning += where_it_acts(each, field);
    }
    const std::string meaning = fmt::format("coefficients of the law \"{}\"", name);
    if (!fields.empty())
      tables.push_back(key_table("run", {.name = "forces", .meaning = meaning}, std::move(fields)));
  }
  return tables;
}

/// The tables of a string on a chain, with a bit that drills or without a shape.
std::vector<KeyTable> chain_tables(const std::string& command) {
  return {
      table_of<SectionSettings>(command, SectionSettings::table),
      table_of<SurveySettings>(command, SurveySettings::table),
      table_of<FrictionCoefficients, StringDamping, TorsionalLoss>(command, StringDamping::table),
      table_of<FrictionAbove>(command, FrictionAbove::table),
      table_of<TopSettings, HookLoad>(command, TopSettings::table),
      table_of<LogSettings, LogStart>(command, LogSettings::table)};
}

std::vector<KeyTable> run_tables() {
  const char* run = "run";
  using bit::AreaSelector;
  using bit::CutterAreaSelector;
  return {table_of<TitleSettings>(run, TitleSettings::table),
          table_of<BitSettings>(run, BitSettings::table),
          table_of<BitChanges>(run, BitChanges::table),
          table_of<RockStart, NamedRock, Surroundings, Bedding>(run, RockStart::table),
          table_of<RockByNumbers>(run, RockByNumbers::table),
          table_of<RockLayer, NamedRock>(run, RockLayer::table),
          table_of<Motion, TopPlan, ConeMotion>(run, Motion::table),
          table_of<Whirl>(run, Whirl::table),
          table_of<Tilt>(run, Tilt::table),
          table_of<Leg>(run, Leg::table),
          table_of<ScheduleSettings>(run, ScheduleSettings::table),
          table_of<TimeSettings>(run, TimeSettings::table),
          table_of<UpdatePlan>(run, UpdatePlan::table),
          table_of<rock::MaintenanceOptions>(run, rock::MaintenanceOptions::table),
          table_of<MeasurePlan>(run, MeasurePlan::table),
          table_of<LawChoice, ForcePlan>(run, ForcePlan::table),
          table_of<KindLaw>(run, KindLaw::table),
          table_of<AreaSelector, AreaLaw>(run, AreaLaw::table),
          table_of<WearLawSettings, WearPlan>(run, WearPlan::table),
          table_of<CutterAreaSelector, WearArea>(run, WearArea::table),
          table_of<BreakoutSettings, BreakingMaterial>(run, BreakoutSettings::table),
          table_of<CutterAreaSelector, BreakoutArea>(run, BreakoutArea::table),
          table_of<LumpedString, ChainSettings, ChainElements>(run, LumpedString::table),
          table_of<WallSettings>(run, WallSettings::table),
          table_of<RockMountSettings>(run, RockMountSettings::table),
          table_of<OutputPlan, ChainOutputSettings>(run, OutputPlan::table)};
}

std::vector<KeyTable> string_tables() {
  const char* string = "string";
  return {table_of<TitleSettings>(string, TitleSettings::table),
          table_of<ChainSettings, ChainElements, ChainEnd, Gravity>(string, ChainSettings::table),
          table_of<SimpleBitSettings>(string, SimpleBitSettings::table),
          table_of<StringMotion>(string, StringMotion::table),
          table_of<RotateTimeSettings>(string, RotateTimeSettings::table),
          table_of<StringOutput, ChainOutputSettings>(string, StringOutput::table)};
}

}  // namespace

CaseKind kind_of(const std::string& file, const std::vector<std::string>& overrides) {
  const Config c = Config::read_file(file, overrides);
  // A string with a bit that has a shape drills.
  const auto found = std::ranges::find_if(signs, [&](const Sign& s) {
    return c.has(s.table) && (s.kind != CaseKind::string || !c.has("bit"));
  });
  return found == std::end(signs) ? CaseKind::unknown : found->kind;
}

void require_kind(const std::string& file, const std::vector<std::string>& overrides,
                  const std::vector<CaseKind>& expected) {
  const CaseKind found = kind_of(file, overrides);
  if (found == CaseKind::unknown || std::ranges::count(expected, found) > 0) return;
  std::string names;
  for (const CaseKind kind : expected)
    names += (names.empty() ? "" : " or ") + std::string(sign_of(kind).name);
  const Sign& sign = sign_of(found);
  throw InputError(fmt::format("{}: found {}, with a table [{}], expected {}; try: tdbd {} {}",
                               file, sign.name, sign.table, names, sign.command, file));
}

std::vector<KeyTable> all_tables() {
  std::vector<KeyTable> all;
  const auto add = [&all](const std::vector<KeyTable>& tables) {
    all.insert(all.end(), tables.begin(), tables.end());
  };
  add(run_tables());
  add(law_tables());
  add(chain_tables("run"));
  add(string_tables());
  add(chain_tables("string"));
  add(tables_of<TitleSettings, BodySettings, ConeSettings, LoadSettings, HarmonicSettings,
                SampleSettings, IntegratorSettings, RotateTimeSettings, RotateOutput>("rotate"));
  add(bit::bit_tables());
  return all;
}

}  // namespace tdbd::simulation

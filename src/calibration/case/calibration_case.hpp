#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bit/areas/area_rules.hpp"
#include "calibration/record/record.hpp"
#include "core/config/config.hpp"
#include "core/config/key_table.hpp"
#include "forces/law.hpp"
#include "forces/rock/rock_material.hpp"
#include "rock/section/breakout.hpp"
#include "simulation/case/rock_settings.hpp"

namespace tdbd::calibration {

struct Tool;
struct Unknown;

/// An area: parts of bits with coefficients of their own. The other parts have those of the law.
struct CoefficientArea {
  std::string name;
  bit::AreaSelector selector;
  /// In the order of the fields of the law: the values that the area sets (SI); for unknowns their
  /// start values.
  std::vector<std::optional<double>> values;
  std::vector<bit::PartKind> kinds = {};  ///< of its parts that use the law
};

/// The areas of a calibration. A mix is a set of coefficients that parts share: for each field of
/// the law the index of the area that determines it, or -1. Mix 0 is that of parts in no area.
struct AreaLaws {
  std::vector<CoefficientArea> areas;
  std::vector<std::vector<int>> mixes;
  std::map<std::string, std::vector<int>> mix_of_part;  ///< by bit
};

/// The tables with the values of areas: [areas.NAME.fixed] and [areas.NAME.unknowns.KEY] of a
/// calibration, or [areas.NAME.truth] of a laboratory.
enum class AreaValues { fitted, truth };

/// Reads [areas.NAME] and adds the unknowns of areas. If several areas set a coefficient of a part,
/// the same rule decides as in bit files (bit/areas). Records as mistakes: those of
/// bit::read_areas, criteria that match no cutter part of any bit, names that are not coefficients,
/// and areas without coefficients.
AreaLaws read_area_laws(Config& c, const forces::Law& law, const std::vector<Tool>& tools,
                        AreaValues values, std::vector<Unknown>& unknowns);

/// Returns the mix of each part of a bit. Empty if every part has mix 0.
std::vector<int> mix_of_parts(const AreaLaws& areas, const std::string& bit);

/// Returns the law of every mix, at least one. `whole`: the law of parts in no area.
std::vector<forces::Law> laws_of_mixes(const AreaLaws& areas, const forces::Law& whole);

/// Returns the areas with these values as TOML tables [forces.areas.NAME-KIND] of a case. Each kind
/// of part that uses the law has its own table, because the other parts of the area have other
/// laws.
std::string areas_toml(const AreaLaws& areas, const forces::Law& law);

/// Whether one set of coefficients is fitted for all bottom hole pressures, or a separate set for
/// each (thesis 6.4.1).
enum class Pressures { combined, separate };

/// The objective of the fit. squares: least squares. huber: readings beyond 1.345 standard deviations
/// count linearly, so that a few wrong ones have little effect (fit/robust.hpp).
enum class Loss { squares, huber };

/// A single cutter on flat rock.
struct SingleCutter {
  double diameter = 0.0;   ///< m
  double back_rake = 0.0;  ///< rad
  double wear_flat = 0.0;  ///< m2
  double chamfer = 0.0;    ///< m, width seen by the rock

  static constexpr TableKey table{"cutters.NAME", "a single cutter that moves along flat rock"};
  void visit(FieldVisitor& v) {
    v(diameter, {.name = "diameter",
                 .unit = "m",
                 .need = Need::required,
                 .range = Range::positive(),
                 .meaning = "of the cutter",
                 .usual = Range::within(0.0, 0.2)});
    v(back_rake, {.name = "back_rake",
                  .unit = "rad",
                  .need = Need::required,
                  .range = Range::within(0.0, 1.3),
                  .meaning = "of its face"});
    v(wear_flat, {.name = "wear_flat",
                  .unit = "m2",
                  .range = Range::non_negative(),
                  .meaning = "area that presses on the rock, as a chamfer does",
                  .usual = Range::within(0.0, 0.01)});
    v(chamfer, {.name = "chamfer",
                .unit = "m",
                .range = Range::non_negative(),
                .meaning = "its width in contact with the rock",
                .usual = Range::within(0.0, 0.05)});
  }
};

/// A bit or a single cutter that has records.
struct Tool {
  std::string name;
  ToolKind kind = ToolKind::bit;
  std::string bit_file;  ///< for a bit
  SingleCutter cutter;   ///< for a single cutter
};

/// [unknowns.KEY]: a coefficient of the law that is fitted.
struct UnknownSettings {
  double start = 0.0;
  std::optional<double> prior_sd;
  std::vector<double> range;  ///< empty: that of the coefficient

  static constexpr TableKey table{"unknowns.KEY", "a coefficient of the law that is fitted"};
  /// `unit`: of the coefficient.
  void visit(FieldVisitor& v, std::string_view unit = "1") {
    v(start, {.name = "start",
              .unit = unit,
              .need = Need::required,
              .meaning = "first value, and the prior's; in the coefficient's unit"});
    v(prior_sd, {.name = "prior_sd",
                 .unit = unit,
                 .computed_default = "no prior",
                 .range = Range::positive(),
                 .meaning = "standard deviation of the prior around start"});
    v(range, {.name = "range",
              .unit = unit,
              .need = Need::optional,
              .computed_default = "that of the coefficient",
              .meaning = "[lowest, highest], in the coefficient's unit"});
  }
};

/// A coefficient to be fitted. SI.
struct Unknown {
  std::string key;
  double start = 0.0;
  std::optional<double> prior_sd;  ///< standard deviation of a normal prior around start
  Range range;
  std::string place;             ///< "FILE:LINE: KEY", for messages
  std::string coefficient = {};  ///< name in the law; empty: `key`
  int area = -1;                 ///< index into AreaLaws::areas; -1: of parts in no area
};

/// Returns the name in the law of the coefficient that an unknown represents.
inline const std::string& law_key(const Unknown& u) {
  return u.coefficient.empty() ? u.key : u.coefficient;
}

/// Relative standard deviations of measurements.
struct Noise {
  double reading = 0.03;  ///< of each load
  double test = 0.0;      ///< of a factor common to all loads of one test
  double rop = 0.0;       ///< of the rate of penetration, or of the depth of a single cutter

  static constexpr TableKey table{"noise", "relative standard deviations of what was measured"};
  void visit(FieldVisitor& v) {
    v(reading, {.name = "reading", .range = Range::positive(), .meaning = "of each load"});
    v(test, {.name = "test",
             .range = Range::non_negative(),
             .meaning = "of a factor on all loads of one test"});
    v(rop, {.name = "rop",
            .range = Range::non_negative(),
            .meaning = "of the rate of penetration, or a cutter's depth"});
  }
};

/// Settings of the cut runs (kinematic runs) that determine the cuts.
struct CutGrid {
  double edge_length = 2e-3;  ///< m, in [rock]
  long revolutions = 3, steps_per_revolution = 250;
  std::optional<rock::BreakoutRule> breakout = std::nullopt;  ///< none: no rock breaks out

  static constexpr TableKey table{"time", "the cut runs: one for each bit and depth of cut"};
  void visit(FieldVisitor& v) {
    v(revolutions,
      {.name = "revolutions", .lo = 2, .hi = 100, .meaning = "of a cut run; its last one counts"});
    v(steps_per_revolution,
      {.name = "steps_per_revolution", .lo = 20, .hi = 100'000, .meaning = "of a cut run"});
  }
  void visit_rock(FieldVisitor& v) {
    v(edge_length, {.name = "edge_length",
                    .unit = "m",
                    .range = Range::within(1e-5, 0.1),
                    .meaning = "of the rock's triangles in the cut runs"});
  }
};

/// The confidence intervals of the result.
struct Intervals {
  double level = 0.95;
  long bootstrap = 0;
  std::uint64_t seed = 1;

  static constexpr TableKey table{"intervals", "confidence intervals of the result"};
  void visit(FieldVisitor& v) {
    v(level, {.name = "level",
              .range = Range::within(0.5, 0.999),
              .meaning = "probability of an interval"});
    v(bootstrap, {.name = "bootstrap", .lo = 0, .hi = 100'000, .meaning = "replicates; 0: none"});
    v(seed, {.name = "seed", .meaning = "of the bootstrap and of further starts"});
  }
};

/// The rock of a test: its materials by name, and the conditions at the bottom of the hole.
struct TestRock {
  std::map<std::string, forces::RockMaterial> materials;  ///< "": the material of the case
  forces::BottomHole around;                              ///< the pressure is set by each record
  forces::Confinement confinement = forces::Confinement::permeable;
};

/// Returns the strength of a record's rock at the pressure of the record.
forces::Strength strength_of(const TestRock& rock, const Record& record);

/// [calibration]: what is fitted to which records.
struct CalibrationSettings {
  std::string law, records;
  std::vector<std::string> fit_bits, predict_bits, leave_out;
  Pressures pressures = Pressures::combined;
  Loss loss = Loss::squares;

  static constexpr TableKey table{"calibration", "what is fitted to which records"};
  void visit(FieldVisitor& v) {
    visit_law(v);
    v.path(records, {.name = "records",
                     .need = Need::required,
                     .meaning = "the readings, csv with units in the header"});
    v(fit_bits, {.name = "fit_bits",
                 .computed_default = "none",
                 .meaning = "bits or cutters whose records are fitted"});
    v(predict_bits, {.name = "predict_bits",
                     .computed_default = "none",
                     .meaning = "bits or cutters whose records are predicted"});
    v(leave_out, {.name = "leave_out",
                  .computed_default = "none",
                  .meaning = "tests that are neither fitted nor predicted"});
    v(pressures,
      {.name = "pressures",
       .values = {{{"combined", Pressures::combined}, {"separate", Pressures::separate}}},
       .meaning = "one set of coefficients for all bottom hole pressures, or one for each"});
    v(loss, {.name = "loss",
             .values = {{{"squares", Loss::squares}, {"huber", Loss::huber}}},
             .meaning = "least squares, or a robust fit: readings far from the law count less"});
  }
  void visit_law(FieldVisitor& v) {
    v.name(law, {.name = "law",
                 .names = &forces::law_names,
                 .need = Need::required,
                 .meaning = "the force law of the cutters"});
  }
};

/// A checked calibration, SI.
struct CalibrationCase {
  std::string path;
  std::vector<std::string> files;
  forces::Law law;  ///< with its fixed coefficients, and the start values of unknown ones
  std::vector<Unknown> unknowns;
  AreaLaws areas;           ///< parts with coefficients of their own
  std::vector<Tool> tools;  ///< those of fit_bits and predict_bits, in this order
  std::vector<std::string> fit, predict;
  Pressures pressures = Pressures::combined;
  Loss loss = Loss::squares;
  Records records;  ///< of `tools`, without the tests that are left out
  TestRock rock;
  CutGrid grid;
  Noise noise;
  Intervals intervals;
  std::string resolved;  ///< TOML in SI; running it gives the same result
  std::string hash;  ///< of the resolved values and the contents of all files except those of bits
  std::string records_hash;
  std::vector<std::string> doubts = {};  ///< "FILE:LINE: KEY: TEXT", of numbers without a unit
};

/// Reads and checks everything without drilling. Throws InputError that lists every mistake.
CalibrationCase read_calibration(const std::string& path,
                                 const std::vector<std::string>& overrides);

// Tables that calibrations and synthetic laboratories share. Mistakes are recorded in the Config.

/// Reads the tools in [bits] and [cutters], sorted by name.
std::vector<Tool> read_tools(Config& c);

/// Reads the rock of [rock] and those of [rocks.NAME].
TestRock read_test_rock(Config& c);

/// Reads the grid of the cut runs from [rock] and [time].
CutGrid read_grid(Config& c);

/// Reads [unknowns.KEY] and [fixed] of a law, and sets its coefficients. A coefficient in neither
/// table has its default; one without a default must be in one of them. Without unknowns, the law
/// is compared with the records unchanged. Mistakes are recorded.
std::vector<Unknown> read_unknowns(Config& c, forces::Law& law);

/// Reads [unknowns.KEY] of a coefficient. Mistakes are recorded.
Unknown read_unknown(Config table, const forces::LawField& field);

/// Records as a mistake every name in a table that is not a coefficient of the law of this name.
void refuse_strangers(Config& table, const std::vector<forces::LawField>& fields,
                      std::string_view law);

/// Returns the tables of a calibration, for `tdbd keys`.
std::vector<KeyTable> calibration_tables();

/// Returns the tool of this name.
const Tool& tool_named(const CalibrationCase& c, const std::string& name);

/// Returns the records of the tools with these names.
std::vector<Record> records_of(const CalibrationCase& c, const std::vector<std::string>& names);

}  // namespace tdbd::calibration

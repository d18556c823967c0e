#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/case/area_laws.hpp"
#include "calibration/case/calibration_keys.hpp"
#include "calibration/record/record.hpp"
#include "forces/law.hpp"
#include "forces/rock/rock_material.hpp"
#include "rock/section/breakout.hpp"
#include "simulation/case/case_rock.hpp"

namespace tdbd::calibration {

/// A single cutter on flat rock.
struct SingleCutter {
  double diameter = 0.0;   ///< m
  double back_rake = 0.0;  ///< rad
  double wear_flat = 0.0;  ///< m2
  double chamfer = 0.0;    ///< m, width seen by the rock
};

/// A bit or a single cutter that has records.
struct Tool {
  std::string name;
  ToolKind kind = ToolKind::bit;
  std::string bit_file;  ///< for a bit
  SingleCutter cutter;   ///< for a single cutter
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
  double reading = 0.0;  ///< of each load
  double test = 0.0;     ///< of a factor common to all loads of one test
  double rop = 0.0;      ///< of the rate of penetration, or of the depth of a single cutter
};

/// Settings of the cut runs (kinematic runs) that determine the cuts.
struct CutGrid {
  double edge_length = 0.0;  ///< m
  long revolutions = 0, steps_per_revolution = 0;
  std::optional<rock::BreakoutRule> breakout = std::nullopt;  ///< none: no rock breaks out
};

struct Intervals {
  double level = 0.95;
  long bootstrap = 0;
  std::uint64_t seed = 1;
};

/// The rock of a test: its materials by name, and the conditions at the bottom of the hole.
struct TestRock {
  std::map<std::string, forces::RockMaterial> materials;  ///< "": the material of the case
  forces::BottomHole around;                              ///< the pressure is set by each record
  forces::Confinement confinement = forces::Confinement::permeable;
};

/// Returns the strength of a record's rock at the pressure of the record.
forces::Strength strength_of(const TestRock& rock, const Record& record);

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
  Records records;  ///< of `tools`, without the tests that are left out
  TestRock rock;
  CutGrid grid;
  Noise noise;
  Intervals intervals;
  std::string resolved;  ///< TOML in SI; running it gives the same result
  std::string hash;  ///< of the resolved values and the contents of all files except those of bits
  std::string records_hash;
};

/// Reads and checks everything without drilling. Throws InputError that lists every mistake.
CalibrationCase read_calibration(const std::string& path,
                                 const std::vector<std::string>& overrides);

/// Returns the tool of this name.
const Tool& tool_named(const CalibrationCase& c, const std::string& name);

/// Returns the records of the tools with these names.
std::vector<Record> records_of(const CalibrationCase& c, const std::vector<std::string>& names);

}  // namespace tdbd::calibration

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/case/area_laws.hpp"
#include "calibration/case/calibration_keys.hpp"
#include "calibration/record/read_records.hpp"
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
  double chamfer = 0.0;    ///< m, width as the rock sees it
};

/// A bit or a cutter of the records.
struct Tool {
  std::string name;
  ToolKind kind = ToolKind::bit;
  std::string bit_file;  ///< of a bit
  SingleCutter cutter;   ///< of a cutter
};

/// A coefficient that is fitted. SI.
struct Unknown {
  std::string key;
  double start = 0.0;
  std::optional<double> prior_sd;  ///< of a normal prior around start
  Range range;
  std::string place;             ///< "FILE:LINE: KEY", for messages
  std::string coefficient = {};  ///< of the law; empty: `key`
  int area = -1;                 ///< index into AreaLaws::areas; -1: of parts in no area
};

/// The coefficient of the law that an unknown is.
inline const std::string& law_key(const Unknown& u) {
  return u.coefficient.empty() ? u.key : u.coefficient;
}

/// Relative standard deviations of what was measured.
struct Noise {
  double reading = 0.0;  ///< of each load
  double test = 0.0;     ///< of a factor on all loads of one test
  double rop = 0.0;      ///< of the rate of penetration, or of a cutter's depth
};

/// How the cuts are found: kinematic runs.
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

/// The rock of a test: its material by name, and what surrounds it beside the pressure.
struct TestRock {
  std::map<std::string, forces::RockMaterial> materials;  ///< "" is that of the case
  forces::BottomHole around;                              ///< its pressure is the record's
  forces::Confinement confinement = forces::Confinement::permeable;
};

/// Strength of a record's rock at its pressure.
forces::Strength strength_of(const TestRock& rock, const Record& record);

/// A checked calibration, SI.
struct CalibrationCase {
  std::string path;
  std::vector<std::string> files;
  forces::Law law;  ///< with its fixed coefficients, and the unknown ones at their starts
  std::vector<Unknown> unknowns;
  AreaLaws areas;           ///< parts with coefficients of their own
  std::vector<Tool> tools;  ///< those of fit and predict, in this order
  std::vector<std::string> fit, predict;
  Pressures pressures = Pressures::combined;
  Records records;  ///< of the tools above, without what is left out
  TestRock rock;
  CutGrid grid;
  Noise noise;
  Intervals intervals;
  std::string resolved;  ///< TOML in SI, itself a case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files but the bits'
  std::string records_hash;
};

/// Reads and checks everything, drills nothing. Throws InputError that lists every mistake.
CalibrationCase read_calibration(const std::string& path,
                                 const std::vector<std::string>& overrides);

/// The tool of this name.
const Tool& tool_named(const CalibrationCase& c, const std::string& name);

/// The records of one of the names.
std::vector<Record> records_of(const CalibrationCase& c, const std::vector<std::string>& names);

}  // namespace tdbd::calibration

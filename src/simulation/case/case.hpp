#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/bit_file.hpp"
#include "core/config/config.hpp"
#include "rock/maintain/limits.hpp"
#include "simulation/case/drilling_settings.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/rock_settings.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {

struct TimeGrid {
  double step = 0.0;  ///< s
  long steps = 0;     ///< from the beginning of the motion to the end of the run
  long first = 0;     ///< steps of the motion that were made before the run
};

/// The time (s) after so many steps.
inline double time_at(const TimeGrid& grid, long steps) {
  return grid.step * static_cast<double>(steps);
}

/// Places of settings whose mistakes are found only with the rock: "FILE:LINE: KEY"
/// (Config::place).
struct CasePlaces {
  std::string edge_length, motion, file, profile, first_step;
};

/// A checked case in SI: the input of a run, and its resolved text.
struct Case {
  std::string path;
  std::string title;  ///< as given, or the bit's name
  CasePlaces places;
  std::vector<std::string> files;  ///< all files that were read: case, bit, tables, meshes
  bit::Bit bit;
  RockStart rock;
  Motion motion;
  TimeGrid time;
  UpdatePlan update;
  rock::MaintenanceOptions maintenance;
  MeasurePlan measure;
  ForcePlan forces;
  WearPlan wear;
  SpallingPlan spalling;
  DrillingPlan drilling;  ///< if the motion is drilling
  OutputPlan output;
  std::vector<CaseWarning> warnings;
  std::string resolved;  ///< TOML with all defaults, in SI; a case with the same result
  std::string hash;      ///< of the resolved values and the contents of all files
  std::string
      bit_hash;  ///< of the inputs of rock::prepare_cutting_bit: bit file, [bit.set], [update]
  std::map<std::string, double> quantities;  ///< of the case file, in SI, by dotted key
};

/// Reads and checks a case without running it. Throws InputError that lists every mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides);

/// bit::read_bit, or a faster function with the same result.
using BitReader =
    std::function<bit::BitFile(const std::string& path, bit::DirectionRule, bit::InsideRule,
                               const std::vector<std::string>& overrides)>;
Case read_case(const std::string& path, const std::vector<std::string>& overrides,
               const BitReader& read_bit);

/// The same for a file or text that is already parsed. `path`: its name.
Case read_case(Config config, const std::string& path);

}  // namespace tdbd::simulation

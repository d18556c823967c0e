#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::calibration {

/// The tested tool: a whole bit, or a single cutter that moves along flat rock.
enum class ToolKind { bit, cutter };

/// The two loads of a test. For a bit: weight (N) and torque (N m). For a cutter: the force into
/// the rock and the drag (N).
using Loads = std::array<double, 2>;
inline constexpr std::size_t axial = 0, turning = 1;

/// A reading of one load in a test.
struct Reading {
  std::optional<double> value;      ///< N or N m, > 0
  std::optional<double> deviation;  ///< same unit, standard deviation of this reading
};

/// One row of a records file, SI: the loads of a tool at one rate and pressure.
struct Record {
  std::string test;       ///< readings of one test have a common factor (Noise::test)
  std::string tool;       ///< name of the bit or of the cutter
  std::string rock;       ///< empty: rock of the case
  double pressure = 0.0;  ///< Pa, of the bottom hole
  double speed = 0.0;     ///< bit: rad/s; cutter: m/s
  double rate = 0.0;      ///< m/s, rate of penetration of a bit; 0 for a cutter
  double depth = 0.0;     ///< m, depth of cut: per revolution of a bit, groove of a cutter
  std::array<Reading, 2> readings;
  long line = 0;  ///< in the file
};

/// Names of the columns of a load: "wob" and "tob", "normal" and "drag".
struct LoadName {
  const char* name;
  const char* si_unit;
};
constexpr std::array<LoadName, 2> load_names(ToolKind kind) {
  if (kind == ToolKind::bit) return {{{"wob", "N"}, {"tob", "N m"}}};
  return {{{"normal", "N"}, {"drag", "N"}}};
}

/// The records of one file, all of bits or all of single cutters.
struct Records {
  std::string file;
  ToolKind kind = ToolKind::bit;
  std::vector<Record> rows;
  std::vector<std::string> doubts;  ///< "FILE:LINE: COLUMN: TEXT": values that usually mean none
};

/// Reads a csv file (core/config/csv.hpp) whose header has "name [unit]" or "name (unit)" in each
/// cell, in any order, in upper or lower case:
///   bits     test, bit, pressure, rotary_speed, rate_of_penetration, wob;
///            tob, wob_sd, tob_sd, rock
///   cutters  test, cutter, speed, depth, normal; pressure, drag, normal_sd, drag_sd, rock
/// Columns after the semicolon are optional. A load may be empty if it was not read. Throws
/// InputError that lists all mistakes: unknown or missing column, wrong unit, no number, a value
/// out of range, a duplicate row.
Records read_records(const std::string& path);

}  // namespace tdbd::calibration

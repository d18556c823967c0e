#pragma once

#include <array>
#include <optional>
#include <string>

namespace tdbd::calibration {

/// What was tested: a whole bit, or a single cutter that moves along flat rock.
enum class ToolKind { bit, cutter };

/// The two loads of a test. Of a bit: weight (N) and torque (N m); of a cutter: the force into the
/// rock and the drag (N).
using Loads = std::array<double, 2>;
inline constexpr std::size_t axial = 0, turning = 1;

/// One load that was read in a test.
struct Reading {
  std::optional<double> value;      ///< N or N m, > 0
  std::optional<double> deviation;  ///< the same, standard deviation of this reading alone
};

/// One row of a records file, SI: the loads of a tool at one rate and pressure.
struct Record {
  std::string test;       ///< readings of one test share a factor (Noise::test)
  std::string tool;       ///< name of the bit or of the cutter
  std::string rock;       ///< empty: that of the case
  double pressure = 0.0;  ///< Pa, of the bottom hole
  double speed = 0.0;     ///< bit: rad/s; cutter: m/s
  double rate = 0.0;      ///< m/s, rate of penetration of a bit; a cutter has none
  double depth = 0.0;     ///< m, of cut: a bit's in one revolution, a cutter's groove
  std::array<Reading, 2> readings;
  long line = 0;  ///< of the file
};

/// How the columns of a load are called: "wob" and "tob", "normal" and "drag".
struct LoadName {
  const char* name;
  const char* si_unit;
};
constexpr std::array<LoadName, 2> load_names(ToolKind kind) {
  if (kind == ToolKind::bit) return {{{"wob", "N"}, {"tob", "N m"}}};
  return {{{"normal", "N"}, {"drag", "N"}}};
}

}  // namespace tdbd::calibration

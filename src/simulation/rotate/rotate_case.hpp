#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/rotation_state.hpp"

namespace tdbd::simulation {

/// Steps of equal length that end exactly at the duration.
struct RotateTime {
  double step = 0.0;      ///< s, the one that is used
  double duration = 0.0;  ///< s
  long steps = 0;
};

/// Reads a table [time]: steps of the given length, or of the next shorter one that fits the
/// duration. Notes mistakes.
RotateTime read_rotate_time(Config c);

/// A checked case of rotational dynamics in SI: all that `tdbd rotate` needs.
/// Thesis: 5.1 to 5.5.
struct RotateCase {
  std::string path;
  std::string title;
  std::vector<std::string> files;  ///< all that were read: case, mesh, samples
  dynamics::Gyrostat body;
  dynamics::RotationState start;
  dynamics::Loads loads;
  dynamics::Integrator integrator;
  RotateTime time;
  long history_every = 1;      ///< steps between rows
  long checkpoint_every = -1;  ///< steps; negative: as often as costs less than 1 % of the time
  std::string resolved;        ///< TOML: all defaults, SI; itself a case that gives the same result
  std::string hash;            ///< of the resolved values and the content of all files
  std::map<std::string, double> quantities;  ///< by dotted key, in SI
};

/// "split", "three-axis", "lie-midpoint", "lie-mean".
std::string drift_name(dynamics::Drift drift);

/// Whether a case file is one of rotational dynamics: it has a table [body]. Throws InputError when
/// the file cannot be read.
bool is_rotate_case(const std::string& path);

/// Reads and checks everything, runs nothing. Throws InputError that lists every mistake.
RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace tdbd::simulation

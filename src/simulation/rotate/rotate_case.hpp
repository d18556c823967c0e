#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/loads.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {

/// Reads [load] of a rotate case, without the torques of its cones. Mistakes are recorded in `c`.
/// Thesis: 5.2.2.
dynamics::Loads read_loads(Config& c);

/// Reads samples of a torque: CSV with the columns time_s, x, y, z in N m. Throws InputError with
/// the line of the file for a missing column, NaN, no rows, or times that do not increase.
dynamics::SampledTorque read_torque_samples(const std::string& file, dynamics::TorqueFrame frame);

/// The body of a rotate case and its initial state.
struct BodyStart {
  dynamics::Gyrostat body;
  dynamics::RotationState state;
  std::vector<dynamics::ConeLoad> cone_loads;  ///< one for each cone
};

/// Reads [body] and [[cones]] of a case and makes the gyrostat. Mistakes are recorded in `c`; the
/// result is then valid but meaningless.
BodyStart read_body_start(Config& c);

/// Steps of equal length; the last one ends exactly at the duration.
struct RotateTime {
  double step = 0.0;      ///< s, the step that is used
  double duration = 0.0;  ///< s
  long steps = 0;
};

/// Reads [time]. If the given step does not divide the duration, the next shorter one that does is
/// used. Records mistakes.
RotateTime read_rotate_time(Config& whole);

/// A checked case of rotational dynamics in SI: the input of `tdbd rotate`. Thesis: 5.1 to 5.5.
struct RotateCase {
  std::string path;
  std::string title;
  std::vector<std::string> files;  ///< all files that were read: case, mesh, samples
  dynamics::Gyrostat body;
  dynamics::RotationState start;
  dynamics::Loads loads;
  dynamics::Integrator integrator;
  RotateTime time;
  long history_every = 1;      ///< steps between rows
  long checkpoint_every = -1;  ///< steps; negative: as often as takes less than 1 % of the run time
  std::string resolved;        ///< TOML with all defaults, SI; running it gives the same result
  std::string hash;            ///< of the resolved values and the contents of all files
  std::map<std::string, double> quantities;  ///< by dotted key, in SI
  std::vector<CaseWarning> warnings;
  std::string place_of_step;  ///< "FILE:LINE: time.step", for warnings of the run
};

/// Largest turn of the body in a step, rad: an integrator of any order needs several steps per
/// revolution.
inline constexpr double largest_turn_in_step = 0.5;

/// Returns "split", "three-axis", "lie-midpoint" or "lie-mean".
std::string drift_name(dynamics::Drift drift);

/// Returns whether a case file describes rotational dynamics, that is, has a table [body]. Throws
/// InputError if the file cannot be read.
bool is_rotate_case(const std::string& path);

/// Reads and checks everything without running. Throws InputError that lists every mistake.
RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace tdbd::simulation

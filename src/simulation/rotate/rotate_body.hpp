#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"

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

}  // namespace tdbd::simulation

#pragma once

#include "core/config/config.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::simulation {

/// Reads [load] of a rotate case, without the torques of its cones. Mistakes are recorded in `c`.
/// Thesis: 5.2.2.
dynamics::Loads read_loads(Config& c);

/// Reads samples of a torque: CSV with the columns time_s, x, y, z in N m. Throws InputError with
/// the line of the file for a missing column, NaN, no rows, or times that do not increase.
dynamics::SampledTorque read_torque_samples(const std::string& file, dynamics::TorqueFrame frame);

}  // namespace tdbd::simulation

#pragma once

#include "core/config/config.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::simulation {

/// Reads [load] of a rotate case and the torques of its [[cones]]. Mistakes are noted in `c`.
/// Thesis: 5.2.2.
dynamics::Loads read_loads(Config& c);

/// Reads samples of a torque: CSV with the columns time_s, x, y, z in N m. Throws InputError for a
/// missing column, NaN, no row, or times that do not rise, with the file's line.
dynamics::SampledTorque read_torque_samples(const std::string& file, dynamics::TorqueFrame frame);

}  // namespace tdbd::simulation

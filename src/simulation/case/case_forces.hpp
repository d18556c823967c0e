#pragma once

#include "core/config/config.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads [forces] (force_keys) and the material of [rock] (read_formation); a run without [forces]
/// computes no forces. Mistakes are noted in the Config.
ForcePlan read_forces(Config& c, const bit::Bit& bit, const MeasurePlan& measure);

}  // namespace tdbd::simulation

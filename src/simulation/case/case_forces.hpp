#pragma once

#include "core/config/config.hpp"
#include "simulation/case/force_plan.hpp"
#include "simulation/case/measure_plan.hpp"

namespace tdbd::simulation {

/// The tables [forces] and [rock] of a case (keys: README.md); without [forces] a run asks for no
/// forces. Mistakes are noted in the Config.
ForcePlan read_forces(Config& c, const bit::Bit& bit, const MeasurePlan& measure);

}  // namespace tdbd::simulation

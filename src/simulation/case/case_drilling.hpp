#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads [string], [wall] and [rock_mount] (drilling_keys.hpp) and joins bit and string: the
/// string's mass stands at the bit's centre of mass. Mistakes are noted in the Config.
DrillingPlan read_drilling(Config& whole, const bit::Bit& bit, const Motion& m, double step,
                           std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation

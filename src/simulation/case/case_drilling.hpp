#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/drilling_plan.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

/// Reads what [motion] says of a bit that drills: the top's speed, and its rate or its weight. The
/// motion that it returns in `m` is what the bit would do if it followed its top.
void read_top(Config c, dynamics::TopDrive& top, Motion& m);

/// Reads [string], [wall] and [rock_mount] (keys: README.md) and puts bit and string together: the
/// string's mass stands at the bit's centre of mass. Mistakes are noted in the Config.
DrillingPlan read_drilling(Config& whole, const bit::Bit& bit, const dynamics::TopDrive& top,
                           const Motion& m);

}  // namespace tdbd::simulation

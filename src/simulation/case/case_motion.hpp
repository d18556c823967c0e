#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

/// The table [motion] (keys: README.md). Mistakes are noted in the Config; those of a path's file
/// join them.
Motion read_motion(Config c);

/// motion.cone_speeds: "rolling", or one speed for each cone of the bit; a bit without parts could
/// not be read.
void read_cone_speeds(Config c, const bit::Bit& bit, Motion& m);

}  // namespace tdbd::simulation

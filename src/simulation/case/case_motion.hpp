#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

/// Reads [motion] (motion_keys.hpp). Mistakes are noted in the Config; those of a path's file join
/// them. The bit tells whether there are cones to turn; one without parts could not be read.
Motion read_motion(Config c, const bit::Bit& bit);

}  // namespace tdbd::simulation

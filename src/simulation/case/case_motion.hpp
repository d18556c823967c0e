#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/rig_log.hpp"

namespace tdbd::simulation {

/// Reads [motion] (motion_keys.hpp). Mistakes are noted in the Config; those of a path's file join
/// them. The bit tells whether there are cones to turn; one without parts could not be read. `log`: what
/// moves the top of a bit that drills, in place of keys.
Motion read_motion(Config c, const bit::Bit& bit, const RigLog& log = {});

}  // namespace tdbd::simulation

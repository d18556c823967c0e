#pragma once

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/rig_log.hpp"

namespace tdbd::simulation {

/// Reads [motion] (motion_keys.hpp). Mistakes, those in the file of a path too, are noted in the Config.
/// `bit`: for its cones; without parts if it could not be read. `log`: the speeds and the hook load of a rig,
/// in place of keys.
Motion read_motion(Config c, const bit::Bit& bit, const RigLog& log = {});

}  // namespace tdbd::simulation

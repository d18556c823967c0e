#pragma once

#include "core/config/config.hpp"
#include "forces/rock/formation.hpp"

namespace tdbd::simulation {

/// What [rock] says of the rock as a material: `material`, pressures, layers (keys: README.md).
/// Mistakes are noted in the Config.
forces::Formation read_formation(Config c);

}  // namespace tdbd::simulation

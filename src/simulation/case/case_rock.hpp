#pragma once

#include "core/config/config.hpp"
#include "forces/rock/formation.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Reads the rock's surface from [rock] (rock_keys). Mistakes are noted in the Config.
RockStart read_rock(Config c);

/// Reads the rock's material, pressures and layers from [rock] (formation_keys). Mistakes are noted
/// in the Config.
forces::Formation read_formation(Config c);

}  // namespace tdbd::simulation

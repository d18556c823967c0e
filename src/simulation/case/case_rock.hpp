#pragma once

#include "core/config/config.hpp"
#include "forces/rock/formation.hpp"
#include "forces/rock/rock_material.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Reads the rock's surface from [rock] (rock_keys). Mistakes are noted in the Config.
RockStart read_rock(Config c);

/// Reads a rock by its name from the table of rocks, or by its numbers from [material].
forces::RockMaterial read_material(Config& c);

/// A rock by the numbers in a table of its own.
forces::RockMaterial read_material_table(Config table);

/// Reads the rock's material, pressures and layers from [rock] (formation_keys). Mistakes are noted
/// in the Config.
forces::Formation read_formation(Config c);

}  // namespace tdbd::simulation

#pragma once

#include "core/config/config.hpp"
#include "forces/rock/rock_material.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Reads the rock's surface from [rock] (rock_keys). Mistakes are noted in the Config.
RockStart read_rock(Config c);

/// Reads a rock by its name from the table of rocks, or by its numbers from [material].
forces::RockMaterial read_material(Config& c);

/// A rock by the numbers in a table of its own.
forces::RockMaterial read_material_table(Config table);

/// Whether [rock] must give the materials of its beds.
enum class BedMaterial { read, unknown };

/// A bed of the formation.
struct Bed {
  forces::RockMaterial material;    ///< without a name where it is unknown
  double confining_pressure = 0.0;  ///< Pa, at the bottom of the hole
};

/// Reads the beds of [rock], from above; without materials the first one alone. Mistakes are noted
/// in the Config.
std::vector<Bed> read_beds(Config c, BedMaterial material);

/// Reads the rock's material, pressures and layers from [rock] (formation_keys). Mistakes are noted
/// in the Config.
forces::Formation read_formation(Config c);

}  // namespace tdbd::simulation

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "forces/rock/quoted.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// A rock as a material.
struct RockMaterial {
  std::string name;
  double unconfined = 0.0;      ///< Pa, compressive strength at no confinement (UCS), > 0
  double friction_angle = 0.0;  ///< rad, of Mohr and Coulomb, in [0, 60 degrees]
  double porosity = 0.2;        ///< 1, effective; used by by_porosity only
};

/// The pressures at the bottom of the hole.
struct BottomHole {
  double pressure = 0.0;       ///< Pa, of the mud
  double pore_pressure = 0.0;  ///< Pa, of the rock's pores
  double overburden = 0.0;     ///< Pa, of the rock above
};

/// Which pressure confines the rock at the bottom. permeable: mud less pore pressure. impermeable:
/// the pores lose pressure as the hole unloads the rock, by a third of overburden less mud (an
/// undrained response after Skempton, from memory). by_porosity: linear between impermeable at a
/// porosity of 0.05 and permeable at 0.20 (from memory).
enum class Confinement { permeable, impermeable, by_porosity };

/// The confining pressure dp, Pa, not below 0: forces (14) in permeable rock, forces (15) in
/// impermeable rock.
double confining_pressure(const BottomHole& hole, Confinement confinement, double porosity);

/// Growth of strength with pressure, (1 + sin phi)/(1 - sin phi): what we take for the thesis's Rs.
double strengthening(double friction_angle);

/// The strength Scc of forces (13), Mohr and Coulomb, with the confining pressure dp.
/// Strength::pressure is the mud's. Thesis: app. C, Scc and P.
Strength strength_of(const RockMaterial& rock, const BottomHole& hole, Confinement confinement);

/// A known rock, with how each number is known and from where.
struct KnownRock {
  std::string_view name;  ///< "berea-sandstone"
  Quoted unconfined;      ///< Pa
  Quoted friction_angle;  ///< rad
  std::string_view source;
};

/// All known rocks.
std::span<const KnownRock> known_rocks();

/// The known rock of this name. Throws InputError, with the names that there are, when there is
/// none.
RockMaterial rock_named(std::string_view name);

}  // namespace tdbd::forces

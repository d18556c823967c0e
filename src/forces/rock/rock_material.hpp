#pragma once

#include <span>
#include <string>
#include <string_view>

#include "forces/rock/quoted.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// The porosity of a rock if none is given.
inline constexpr double usual_porosity = 0.2;

/// Material properties of a rock.
struct RockMaterial {
  std::string name;
  double unconfined = 0.0;           ///< Pa, unconfined compressive strength (UCS), > 0
  double friction_angle = 0.0;       ///< rad, Mohr-Coulomb, in [0, 60 degrees]
  double porosity = usual_porosity;  ///< 1, effective; only used by by_porosity
};

/// The pressures at the bottom of the hole.
struct BottomHole {
  double pressure = 0.0;       ///< Pa, of the mud
  double pore_pressure = 0.0;  ///< Pa, in the pores of the rock
  double overburden = 0.0;     ///< Pa, of the rock above
};

/// The pressure that confines the rock at the bottom.
/// - permeable: mud pressure minus pore pressure.
/// - impermeable: unloading by the hole lowers the pore pressure by a third of overburden minus mud
///   pressure (an undrained response after Skempton, from memory).
/// - by_porosity: linear between impermeable at a porosity of 0.05 and permeable at 0.20 (from
///   memory).
enum class Confinement { permeable, impermeable, by_porosity };

/// The confining pressure dp, Pa, not below 0: forces (14) in permeable rock, forces (15) in
/// impermeable rock.
double confining_pressure(const BottomHole& hole, Confinement confinement, double porosity);

/// Increase of strength with pressure, (1 + sin phi)/(1 - sin phi), interpreted as Rs of the
/// thesis.
double strengthening(double friction_angle);

/// The strength Scc of forces (13), Mohr-Coulomb, with the confining pressure dp.
/// Strength::pressure is the mud pressure. Thesis: app. C, Scc and P.
Strength strength_of(const RockMaterial& rock, const BottomHole& hole, Confinement confinement);

/// A known rock. Each number states how it is known; `source` is its source.
struct KnownRock {
  std::string_view name;  ///< for example "berea-sandstone"
  Quoted unconfined;      ///< Pa
  Quoted friction_angle;  ///< rad
  std::string_view source;
};

/// All known rocks.
std::span<const KnownRock> known_rocks();

/// The known rock with this name. Throws InputError with the list of names if there is none.
RockMaterial rock_named(std::string_view name);

}  // namespace tdbd::forces

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "forces/rock/quoted.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// The porosity of a rock that tells none.
inline constexpr double usual_porosity = 0.2;

/// A rock as a material.
struct RockMaterial {
  std::string name;
  double unconfined = 0.0;           ///< Pa, compressive strength at no confinement (UCS), > 0
  double friction_angle = 0.0;       ///< rad, of Mohr and Coulomb, in [0, 60 degrees]
  double porosity = usual_porosity;  ///< 1, effective; only by_porosity asks for it
};

/// The pressures at the bottom of the hole.
struct BottomHole {
  double pressure = 0.0;       ///< Pa, of the mud
  double pore_pressure = 0.0;  ///< Pa, of the rock's pores
  double overburden = 0.0;     ///< Pa, of the rock above
};

/// Which pressure confines the rock at the bottom. permeable: mud less pores. impermeable: the
/// pores lose pressure as the hole relieves the rock, by a third of overburden less mud (a
/// Skempton-type undrained response, from memory). by_porosity: linear between impermeable at a
/// porosity of 0.05 and permeable at 0.20 (from memory).
enum class Confinement { permeable, impermeable, by_porosity };

/// The confining pressure, Pa, not below 0:
///   permeable    dp = p - pp
///   impermeable  dp = p - (pp - (ob - p)/3)
double confining_pressure(const BottomHole& hole, Confinement confinement, double porosity);

/// Strengthening by pressure, (1 + sin phi)/(1 - sin phi): the thesis's Rs, as we take it.
double strengthening(double friction_angle);

/// Scc = UCS + dp (1 + sin phi)/(1 - sin phi): Mohr and Coulomb, with the confining pressure dp.
/// Strength::pressure is the mud's. Thesis: app. C, Scc and P.
Strength strength_of(const RockMaterial& rock, const BottomHole& hole, Confinement confinement);

/// A rock of the table, with how each number is known and from where.
struct KnownRock {
  std::string_view name;  ///< "berea-sandstone"
  Quoted unconfined;      ///< Pa
  Quoted friction_angle;  ///< rad
  std::string_view source;
};

std::span<const KnownRock> known_rocks();

/// The rock of this name in the table. InputError: there is none; tells those that there are.
RockMaterial rock_named(std::string_view name);

}  // namespace tdbd::forces

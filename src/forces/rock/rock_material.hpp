#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::forces {

/// The item with this name; `name_of` returns the name of an item. Throws InputError "found the
/// WHAT "NAME", expected one of ..." if there is none. `what` is the kind of item.
template <class Items, class NameOf>
const auto& find_by_name(std::string_view what, std::string_view name, const Items& items,
                         NameOf name_of) {
  std::string all;
  for (const auto& item : items) {
    if (name_of(item) == name) return item;
    all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", name_of(item));
  }
  throw InputError(fmt::format("found the {} \"{}\", expected one of {}", what, name, all));
}

inline constexpr double MPa = 1e6;  ///< Pa

/// How a number is known.
enum class Evidence {
  seen,     ///< read in a source
  derived,  ///< computed from numbers that were read
  recall,   ///< from memory, no source at hand
  assumed,  ///< assumed by TDBD, for lack of any source
};

/// "seen", "derived", "recall", "assumed".
constexpr std::string_view evidence_name(Evidence e) {
  return e == Evidence::seen      ? "seen"
         : e == Evidence::derived ? "derived"
         : e == Evidence::recall  ? "recall"
                                  : "assumed";
}

/// A number (SI) and how it is known.
struct Quoted {
  double value = 0.0;
  Evidence evidence = Evidence::assumed;
};

/// The strength of the rock at the contact with a part. Thesis: app. C (Scc, P), nomenclature.
struct Strength {
  double unconfined = 0.0;      ///< Pa, compressive strength without confinement
  double confined = 0.0;        ///< Pa, compressive strength under bottom-hole pressure (Scc)
  double friction_angle = 0.0;  ///< rad, internal (Mohr-Coulomb)
  double pressure = 0.0;        ///< Pa, at the bottom of the hole (P)
};

/// The porosity of a rock if none is given.
inline constexpr double default_porosity = 0.2;

/// Material properties of a rock.
struct RockMaterial {
  std::string name;
  double unconfined = 0.0;             ///< Pa, unconfined compressive strength (UCS), > 0
  double friction_angle = 0.0;         ///< rad, Mohr-Coulomb, in [0, 60 degrees]
  double porosity = default_porosity;  ///< 1, effective; only used by by_porosity
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

/// Rock in layers between parallel planes, level or dipping.
struct Formation {
  Vec3 normal_W = Vec3(0, 0, 1);  ///< unit normal of the planes, towards the deeper layers
  std::vector<double> tops;  ///< m, normal_W . x of the planes, ascending: tops of layers 1, 2, ...
  std::vector<Strength> strengths;  ///< of layers 0, 1, ...: one more than tops
};

/// The normal of beds that dip by an angle (rad, from horizontal) towards an azimuth (rad, about +z
/// from +x), in which direction they get deeper (z is down).
Vec3 bedding_normal(double dip, double azimuth);

/// The layer of a point: 0 above the first plane. A point on a plane belongs to the layer below.
/// Run time is logarithmic in the number of layers; does not allocate.
std::size_t layer_at(const Formation& formation, const Vec3& x_W);

/// The strength of the rock at a point.
const Strength& strength_at(const Formation& formation, const Vec3& x_W);

/// Why this is not a valid formation (wrong number of strengths, planes out of order, a normal that
/// is not a unit vector, a strength that is not positive); empty if it is valid.
std::string formation_problem(const Formation& formation);

}  // namespace tdbd::forces

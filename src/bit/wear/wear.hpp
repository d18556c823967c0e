#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Contact of a surface of the bit with rock at one time.
struct WearContact {
  double normal_force = 0.0;  ///< N, between the surface and the rock
  double speed = 0.0;         ///< m/s, of the surface over the rock
  double temperature = 0.0;   ///< K, of the surface
};

/// A surface that does not wear.
struct NoWear {
  static constexpr std::string_view name = "none";
  bool operator==(const NoWear&) const = default;
};

/// Archard's law: the worn volume is proportional to normal force and path, and inversely
/// proportional to hardness.
struct SlidingWear {
  static constexpr std::string_view name = "sliding";
  double coefficient = 0.0;  ///< k, 1
  double hardness = 0.0;     ///< H, Pa, of the surface, above 0
  bool operator==(const SlidingWear&) const = default;
};

/// Glowka's thermal wear: sliding wear that is faster above a threshold temperature. The existence
/// of a threshold is stated in the abstract of SPE 14222; the exponential form is not from there.
struct ThermalWear {
  static constexpr std::string_view name = "thermal";
  SlidingWear sliding;
  double threshold = 0.0;  ///< K
  double growth = 0.0;     ///< K, above 0: an excess by this amount multiplies the rate by e
  bool operator==(const ThermalWear&) const = default;
};

/// Measured wear: volume per work of the normal force as a function of temperature. Linear between
/// the temperatures, constant below the first and above the last.
struct TableWear {
  static constexpr std::string_view name = "table";
  std::vector<double> temperatures;  ///< K, ascending
  std::vector<double> rates;         ///< m3/(N m), one for each temperature
  bool operator==(const TableWear&) const = default;
};

using WearLaw = std::variant<NoWear, SlidingWear, ThermalWear, TableWear>;

/// The worn volume per path and normal force, m3/(N m), at this temperature (K); bit (16).
double wear_coefficient(const WearLaw& law, double temperature);

/// The rate of worn volume, m3/s: C(T) Fn v; bit (16).
double wear_rate(const WearLaw& law, const WearContact& contact);

/// Heating of a wear flat. The heat of friction is divided between the rock, a half-space that
/// slides past, and the cutter, a thermal resistance. The formula is from memory of Glowka and
/// Stone.
struct FlatHeating {
  double friction = 0.15;             ///< mu, 1
  double rock_conductivity = 3.5;     ///< W/(m K), above 0
  double rock_diffusivity = 1.5e-6;   ///< m2/s
  double cutter_resistance = 0.3e-4;  ///< K m2/W, from the flat to the drilling fluid
  double fluid_temperature = 293.15;  ///< K
};

/// The contact that heats a flat.
struct FlatContact {
  double normal_force = 0.0;  ///< N
  double speed = 0.0;         ///< m/s
  double area = 0.0;          ///< m2, on which the force acts
  double length = 0.0;        ///< m, of the flat along the motion
};

/// Mean temperature of a flat, K; bit (17). Equal to that of the fluid without force, area or
/// motion.
double flat_temperature(const FlatHeating& heating, const FlatContact& contact);

/// A piece of a bit that wears: a cutter with all its parts, a tooth, or a gage pad. The surfaces
/// of a cutter are those of the parts whose volumes add up to its own; a face enclosed by a chamfer
/// is omitted. Frame C: of the cutter, or of the part.
struct WearSolid {
  std::string name;        ///< "cutter-12", or that of the part
  std::vector<int> parts;  ///< of the bit, which a flat truncates
  int cutter = -1;         ///< index into Bit::cutters, or -1
  Vec3 normal_C =
      Vec3::Zero();  ///< into the rock: the profile's normal, a tooth's axis, a pad's radius
  Vec3 motion_C = Vec3::Zero();  ///< along the motion, in the flat
  Vec3 tip_C = Vec3::Zero();  ///< m: tip of a cutter, for others a point farthest along the normal
  double start = 0.0;    ///< m, largest height at which no volume is lost: that of the flat in the
                         ///< table, or with side rake a few micrometres below 0 (cutter_pose)
  double size = 0.0;     ///< m: a cutter's diameter, a tooth's protrusion, a pad's thickness
  double largest = 0.0;  ///< m, height of the largest flat
  std::vector<std::array<Vec3, 3>> triangles_C;  ///< m, from the tip, outward
  std::vector<std::array<double, 3>> depth;      ///< m, of their corners below the tip
};

/// Returns the pieces of a bit in their initial state, with the flats of their table: all cutters,
/// and those teeth and gage pads whose part is marked in `wears` (one mark per part; empty: none).
/// The largest flat of a cutter is as wide as the cutter: its height is half of the diameter,
/// measured on the face. A tooth may wear down to 0.95 of its protrusion, a pad to half of its
/// thickness. Throws InputError for a marked pad that is not convex.
std::vector<WearSolid> wear_solids(const Bit& bit, std::span<const std::uint8_t> wears = {});

/// A wear flat: the section of a piece by the plane that is `height` below its tip.
struct WearFlat {
  double height = 0.0;  ///< m, along the normal (Cutter::wear)
  double volume = 0.0;  ///< m3, of the solid beyond the plane
  double area = 0.0;    ///< m2
  double length = 0.0;  ///< m, extent along the motion
  double width = 0.0;   ///< m, extent across the motion
};

/// The flat at a height (m). Volume and area are exact for the mesh: sums over the parts of its
/// triangles beyond the plane.
WearFlat flat_at(const WearSolid& solid, double height);

/// The flat whose volume is `volume` (m3), to a relative 1e-14 or to the rounding of its height.
/// Newton's method, bracketed between `from` (m, a height whose volume is not larger) and the
/// largest flat, with bisection where Newton's method leaves the bracket; at most 200 evaluations.
/// Returns nothing if the volume is that of the largest flat or more. Deterministic.
std::optional<WearFlat> flat_of_volume(const WearSolid& solid, double volume, double from);

/// Truncates the parts of a piece to a flat at this height (m). For a cutter, sets Cutter::wear to
/// the height, but at least 0. `fresh`: the bit before any wear of the run. Its parts are
/// truncated, so that rounding errors do not accumulate. In `bit` only the meshes of these parts
/// and that Cutter::wear change. Parts keep their number and order. Throws RunError if a part would
/// be removed entirely; `bit` is then unchanged.
void wear_piece(const Bit& fresh, const WearSolid& solid, double height, Bit& bit);

/// The volume that a worn piece has lost, m3, computed from its meshes alone, independently of
/// flat_at.
struct LostVolume {
  double beyond_flat = 0.0;  ///< of the parts of the fresh meshes beyond the plane of the flat
  double by_meshes = 0.0;    ///< difference of the volumes of the fresh and the worn meshes
  double whole = 0.0;        ///< of the fresh meshes; by_meshes is exact to its rounding
};

/// `height`: of the flat, m.
LostVolume lost_volume(const Bit& fresh, const Bit& worn, const WearSolid& solid, double height);

/// The IADC dull grades of the cutting structure, integers from 0 (no wear) to 8 (no usable cutter
/// or tooth left): the mean worn fraction of the cutters' diameters, or of the teeth's protrusions,
/// in eighths, rounded.
struct DullGrade {
  int inner = 0;  ///< of cutters and teeth within two thirds of the gage radius
  int outer = 0;  ///< of the rest
};

/// `heights`: of the flats, m, one per solid; for cutters measured on the face. Gage pads do not
/// count. The grade of a group without cutters and teeth is 0.
DullGrade dull_grade(const Bit& bit, std::span<const WearSolid> solids,
                     std::span<const double> heights);

}  // namespace tdbd::bit

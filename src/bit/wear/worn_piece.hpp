#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A piece of a bit that wears: a cutter with all its parts, a tooth, or a gage pad. Of a cutter the
/// surfaces are those of the parts whose volumes add up to its own; a face that a chamfer encloses is
/// left out. Frame C: of the cutter, or of the part.
struct WearSolid {
  std::string name;        ///< "cutter-12", or that of the part
  std::vector<int> parts;  ///< of the bit, that a flat cuts
  int cutter = -1;         ///< index into Bit::cutters, or -1
  Vec3 normal_C =
      Vec3::Zero();  ///< into the rock: the profile's normal, a tooth's axis, a pad's radius
  Vec3 motion_C = Vec3::Zero();  ///< along the motion, in the flat
  Vec3 tip_C =
      Vec3::Zero();    ///< m: of a cutter its tip, of others a point farthest along the normal
  double start = 0.0;  ///< m, height at which no volume is lost yet: that of the flat of the table,
                       ///< or with side rake a few micrometres below 0 (cutter_pose)
  double size = 0.0;   ///< m: a cutter's diameter, a tooth's protrusion, a pad's thickness
  double largest = 0.0;                          ///< m, height of the largest flat
  std::vector<std::array<Vec3, 3>> triangles_C;  ///< m, from the tip, outward
  std::vector<std::array<double, 3>> depth;      ///< m, of their corners below the tip
};

/// The pieces of a bit as they are at the start, with the flats of their table: all cutters, and the
/// teeth and gage pads among the parts with a mark in `wears` (one a part; empty: none). The largest
/// flat of a cutter is as wide as its cutter: its height is half of the diameter, measured on the
/// face. A tooth may wear down to 0.95 of its protrusion, a pad to half of its thickness. Throws
/// InputError for a marked pad that is not convex.
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

/// The flat whose volume is `volume` (m3), to 1e-14 of it or to the rounding of its height. Newton's
/// method in a bracket between `from` (m, a height whose volume is not larger) and the largest flat,
/// halved where Newton's method leaves it; at most 200 evaluations. None: the volume is that of the
/// largest flat or more. Deterministic.
std::optional<WearFlat> flat_of_volume(const WearSolid& solid, double volume, double from);

/// Cuts the parts of a piece down to a flat at this height (m) and sets the Cutter::wear of a cutter to
/// it, or 0. `fresh`: the bit before any wear of the run, whose parts are cut, so that no rounding adds
/// up; of `bit`, only the meshes of these parts and that Cutter::wear change. Parts keep their number
/// and order. Throws RunError if a part would be removed entirely; `bit` is then unchanged.
void wear_piece(const Bit& fresh, const WearSolid& solid, double height, Bit& bit);

/// What a worn piece lacks, m3, by its meshes alone: nothing here knows of flat_at.
struct LostVolume {
  double beyond_flat = 0.0;  ///< of what of the fresh meshes is beyond the plane of the flat
  double by_meshes = 0.0;    ///< of the fresh meshes less that of the worn ones
  double whole = 0.0;        ///< of the fresh meshes, to whose rounding by_meshes is exact
};

/// `height`: of the flat, m.
LostVolume lost_volume(const Bit& fresh, const Bit& worn, const WearSolid& solid, double height);

/// The IADC dull grades of the cutting structure, whole numbers from 0 (no wear) to 8 (no usable
/// cutter or tooth left): the mean share of the cutters' diameters, or of the teeth's protrusions,
/// that is worn, in eighths, rounded.
struct DullGrade {
  int inner = 0;  ///< of what cuts within two thirds of the gage radius
  int outer = 0;  ///< of the rest
};

/// `heights`: of the flats, m, one a solid; of cutters measured on the face. Gage pads do not count. 0
/// of a group without cutters and teeth.
DullGrade dull_grade(const Bit& bit, std::span<const WearSolid> solids,
                     std::span<const double> heights);

}  // namespace tdbd::bit

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The material of a cutter that wears: the surfaces of the parts whose volumes add up to that of the
/// cutter, about its tip. A face that a chamfer encloses is left out.
struct WearSolid {
  int id = 0;                    ///< Cutter::id
  Vec3 normal_C = Vec3::Zero();  ///< into the rock: the profile's normal
  Vec3 motion_C = Vec3::Zero();  ///< along the motion, in the flat
  double start = 0.0;  ///< m, height at which no volume is lost yet: that of the flat of the table,
                       ///< or with side rake a few micrometres below 0 (cutter_pose)
  double diameter = 0.0;                         ///< m
  double largest = 0.0;                          ///< m, height of the largest flat
  std::vector<std::array<Vec3, 3>> triangles_C;  ///< m, from the tip, outward
  std::vector<std::array<double, 3>> depth;      ///< m, of their corners below the tip
};

/// The solids of a bit's cutters as they are at the start, with the flats of their table. The largest
/// flat is as wide as its cutter: its height is half of the diameter, measured on the face.
std::vector<WearSolid> wear_solids(const Bit& bit);

/// A wear flat: the section of a cutter by the plane that is `height` below its tip.
struct WearFlat {
  double height = 0.0;  ///< m, along the profile's normal (Cutter::wear)
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

/// Cuts the parts of a cutter down to a flat at this height (m) and sets its Cutter::wear to it, or 0.
/// `fresh`: the bit before any wear of the run, whose parts are cut, so that no rounding adds up; of
/// `bit`, only the meshes of this cutter's parts and its Cutter::wear change. Parts keep their
/// number and order. Throws RunError if a part would be removed entirely; `bit` is then unchanged.
void wear_cutter(const Bit& fresh, int cutter, double height, Bit& bit);

/// What a worn cutter lacks, m3, by its meshes alone: nothing here knows of flat_at.
struct LostVolume {
  double beyond_flat = 0.0;  ///< of the pieces of the fresh meshes beyond the plane of Cutter::wear
  double by_meshes = 0.0;    ///< of the fresh meshes less that of the worn ones
  double whole = 0.0;        ///< of the fresh meshes, to whose rounding by_meshes is exact
};

LostVolume lost_volume(const Bit& fresh, const Bit& worn, int cutter);

/// A bit whose cutters lost these volumes (m3, per cutter), and the flats.
struct WornBit {
  Bit bit;
  std::vector<WearFlat> flats;
};

/// Throws RunError naming the cutter whose flat would be as large as the cutter.
WornBit worn_bit(const Bit& fresh, const std::vector<double>& volumes);

/// The IADC dull grades of the cutting structure, whole numbers from 0 (no wear) to 8 (no usable
/// cutter left): the mean share of the cutters' diameters that is worn, in eighths, rounded.
struct DullGrade {
  int inner = 0;  ///< of the cutters within two thirds of the gage radius
  int outer = 0;  ///< of the others
};

/// From the heights Cutter::wear, measured on the face; 0 of a group without cutters.
DullGrade dull_grade(const Bit& bit);

}  // namespace tdbd::bit

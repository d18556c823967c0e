#pragma once

#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Design parameters of blades and of the junk slots between them. Lengths in m.
struct BladeOptions {
  double exposure = 5e-3;     ///< of a face cutter's tip above its blade, along the normal
  double slot_depth = 18e-3;  ///< from a blade's top to the slot's floor, along the normal
  double width = 0.0;         ///< of the top of a blade; 0: as wide as its cutters require
  double wall = 4e-3;         ///< length of the wall of a slot, from top to floor
  double gage_length = 0.05;  ///< of the blades above the last face cutter
  double neck = 0.02;         ///< height of the transition from gage to shank
  double shank_radius = 0.7;  ///< times the gage radius
  double shank_length = 1.0;  ///< times the gage radius
  double edge = 4e-3;         ///< largest step of the mesh along the profile and across a blade
  double density = 7850.0;    ///< kg/m3
  Cutting cutting = Cutting::rubs;
};

/// A point of the half-plane (r, z), z down as in the bit frame. m.
struct HalfPlanePoint {
  double r = 0.0;
  double z = 0.0;
};

/// A place on the meridian: the points of the blades' tops and of the slots' floors.
struct MeridianNode {
  double s = 0.0;  ///< m, along the tips of the face cutters from the axis
  HalfPlanePoint top, floor;
};

/// A blade: a strip behind the line of its cutters' tips, bit (6). At s its front is at the azimuth
/// of that line. With x along that azimuth and y ahead of it, the top is -width <= y <= 0, x >=
/// start.
struct BladeStrip {
  int blade = 0;                                 ///< its number in the table
  std::vector<std::pair<double, double>> front;  ///< (s, azimuth in rad, unwrapped), ascending in s
  double width = 0.0;                            ///< m
  double start = 0.0;                            ///< m
};

/// The smooth body, bit (6). In the half-plane at an azimuth its surface is
///   x(s) = top(s) + f(s, azimuth) (floor(s) - top(s)),   f in [0, 1],
/// with f = 0 on every blade and f = 1 on the floor of a slot; across a wall f is linear in the
/// distance from a strip. Blades merge where strips meet, near the axis.
struct BladeShape {
  std::vector<MeridianNode> meridian;  ///< from the axis to the upper end of the gage
  /// (s, tip) of the face cutters, ascending in s
  std::vector<std::pair<double, HalfPlanePoint>> tips;
  /// sorted by the azimuth of their fronts at the gage
  std::vector<BladeStrip> blades;
  double wall = 0.0;  ///< m
};

/// Computes the shape for the cutters of a table. Tops are `exposure` behind the tips of the face
/// cutters (those without under-exposure), linear between them; floors are slot_depth behind the
/// tops. Requires at least one cutter. Thesis: 3.1 (bit body); the shape is not in the thesis.
BladeShape blade_shape(const std::vector<Cutter>& cutters, const BladeOptions& options);

/// The meridian at s (m), linearly interpolated between the nodes.
MeridianNode meridian_at(const BladeShape& shape, double s);

/// Azimuth (rad) of a blade's front at s; constant before its first and after its last cutter.
double front_at(const BladeStrip& blade, double s);

/// The fraction f of bit (6): how far the surface lies in the slot; 0 on a blade's top.
double sunk_share(const BladeShape& shape, const MeridianNode& at, double azimuth);

/// The surface at a point of the meridian and an azimuth (rad), bit frame, m.
Vec3 surface_point_B(const BladeShape& shape, const MeridianNode& at, double azimuth);

/// How far a cutter's body extends behind the blade's front, m, across the blade: the width that
/// the blade needs for it.
double trail_of(const BladeStrip& blade, const Cutter& c, double s);

/// The position of a cutter along the meridian, m: the point nearest to its tip, corrected for its
/// under-exposure.
double place_of(const BladeShape& shape, const Cutter& c);

}  // namespace tdbd::bit

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// Depth where there is nothing.
inline constexpr double no_depth = -std::numeric_limits<double>::infinity();

/// The rim of a cutter's face, a circle in the bit's frame: centre + down cos s + side sin s.
/// Computed from the table alone, not from the cutter's pose. A chamfer lies inside it.
struct CutterRim {
  Vec3 tip_B, centre_B;   ///< m
  Vec3 down_B, side_B;    ///< m, radii of the circle: towards the tip, and perpendicular to it
  Vec3 motion_B;          ///< unit, +azimuth at the tip
  Vec3 face_B, normal_B;  ///< unit: outward normal of the face; normal of the profile into the rock
  double wear = 0.0;      ///< m, height of the flat along the profile's normal
};

/// Makes the rim with this side rake, rad; the planar form of outlines uses none.
CutterRim cutter_rim(const bit::Cutter& c, double side_rake);

/// Projection of a rim on a plane through the axis, along the plane's normal: the ellipse z = z0 +
/// slope (x - x0) +- bulge sqrt(1 - ((x - x0)/half_width)^2), truncated by the wear flat.
struct RimEllipse {
  double x0 = 0.0, z0 = 0.0, half_width = 0.0, bulge = 0.0;  ///< m
  double slope = 0.0;
  double normal_x = 0.0, normal_z = 1.0, flat = 0.0;  ///< rock remains below normal . (x, z) = flat
  bool is_worn = false;

  double reach() const { return x0 + half_width; }  ///< of the unworn rim, m
};

/// `radial_B`: horizontal unit vector, the direction of the plane's x. The plane contains the bit's
/// axis.
RimEllipse rim_ellipse(const CutterRim& rim, const Vec3& radial_B);

/// Depth of the unworn rim's branches at x, m; beside the rim, that of its ends.
inline double branch_bulge(const RimEllipse& e, double x) {
  const double share = (x - e.x0) / e.half_width;
  return e.bulge * std::sqrt(std::max(0.0, 1.0 - share * share));
}
inline double lower_branch(const RimEllipse& e, double x) {
  return e.z0 + e.slope * (x - e.x0) + branch_bulge(e, x);
}
inline double upper_branch(const RimEllipse& e, double x) {
  return e.z0 + e.slope * (x - e.x0) - branch_bulge(e, x);
}

/// The lower branch, truncated by the flat.
inline double worn_depth(const RimEllipse& e, double x, double upper, double lower) {
  if (e.normal_x * x + e.normal_z * lower <= e.flat) return lower;
  constexpr double upright = 1e-9;  // the flat of a gage cutter is parallel to the axis
  if (e.normal_z < upright) return no_depth;
  const double flat = (e.flat - e.normal_x * x) / e.normal_z;
  return flat >= upper ? flat : no_depth;
}

/// The lower branch at x, m; no_depth beside the rim.
inline double depth_at(const RimEllipse& e, double x) {
  const double share = (x - e.x0) / e.half_width, square = 1.0 - share * share;
  if (!(square >= 0.0)) return no_depth;
  const double middle = e.z0 + e.slope * (x - e.x0), chord = e.bulge * std::sqrt(square);
  return e.is_worn ? worn_depth(e, x, middle - chord, middle + chord) : middle + chord;
}

}  // namespace tdbd::reference

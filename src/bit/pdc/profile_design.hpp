#pragma once

#include <array>

namespace tdbd::bit {

/// Design parameters of a bit's profile: a straight cone, the nose's arc, the shoulder's arc,
/// tangent to the nose and to the gage, and the gage; bit (3) and (4). SI. Not in the thesis.
struct ProfileDesign {
  double gage_radius = 0.0;
  double cone_angle = 0.0;      ///< rad, of the cone's line above the horizontal
  double nose_place = 0.0;      ///< m, radius at which the profile is lowest
  double nose_radius = 0.0;     ///< m, of the nose's arc
  double shoulder_angle = 0.0;  ///< rad, profile angle at which the shoulder's arc begins
  double gage_length = 0.0;     ///< m, along the axis
};

/// The pieces of the profile, from the axis to the gage's upper end.
enum class Region { cone, nose, shoulder, gage };

/// A point of the profile.
struct ProfileSpot {
  double r = 0.0;      ///< m, from the axis
  double h = 0.0;      ///< m, above the lowest point
  double angle = 0.0;  ///< rad, of the normal into the rock: (sin, cos) in (r, z), z down
  Region region = Region::cone;
};

/// Radius of the shoulder's arc, m, which is tangent to nose and gage, bit (3); <= 0 if the profile
/// folds.
double shoulder_radius(const ProfileDesign& p);

/// The shoulder_angle (rad) for a shoulder of this radius (m), the alternative parameter of a
/// profile. NaN if there is none.
double shoulder_angle_for(const ProfileDesign& p, double radius);

/// Arc lengths, m, from the axis to the end of each region.
std::array<double, 4> region_ends(const ProfileDesign& p);

/// The point at the arc length s (m) from the axis, 0 <= s <= the end of the gage; bit (4).
ProfileSpot spot_at(const ProfileDesign& p, double s);

}  // namespace tdbd::bit

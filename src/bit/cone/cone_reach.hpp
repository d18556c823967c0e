#pragma once

#include "bit/bit.hpp"
#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// How far a point of a cone reaches in a full turn of the cone, with the bit at rest.
struct ConeReach {
  double radius = 0.0;  ///< m, largest distance from the bit's axis
  double angle = 0.0;   ///< rad about the cone's Z (in K at angle 0) at that place
  double depth = 0.0;   ///< m, largest z in the bit's frame
};

/// The reach of the point (s, r) of a cone with frame X_BK. The radius is largest at a root of a
/// trigonometric polynomial of degree 2, which is bracketed and bisected to rounding.
ConeReach reach_of(const Pose& X_BK, const ShellPoint& p);

/// The reach of a meridian: the largest over its corners.
ConeReach reach_of(const Pose& X_BK, const Meridian& m);

/// The position along the journal (ConeLayout::apex, m) at which the cone's gage rows reach
/// `gage_radius` (m). Throws InputError if there is none: an offset beyond the gage, or a cone too
/// large or too small for the bit. Requires a gage row.
double apex_for_gage(ConeLayout cone, double gage_radius);

/// Largest distance (m) from the bit's axis that a cutting part's vertex reaches during a turn of
/// its cone.
double largest_turned_radius(const Bit& bit);

}  // namespace tdbd::bit

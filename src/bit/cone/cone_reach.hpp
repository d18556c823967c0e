#pragma once

#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// What a point of a cone reaches in a full turn of the cone, the bit at rest.
struct Reach {
  double radius = 0.0;  ///< m, farthest from the bit's axis
  double angle = 0.0;   ///< rad about the cone's Z (in K at angle 0) where that is
  double depth = 0.0;   ///< m, largest z in the bit's frame
};

/// Of the place (s, r) of a cone whose frame is X_BK. The radius is the largest root of a
/// trigonometric polynomial of degree 2, bracketed and bisected to rounding.
Reach reach_of(const Pose& X_BK, const ShellPoint& p);

/// Of a meridian: the largest over its corners.
Reach reach_of(const Pose& X_BK, const Meridian& m);

/// Place of the cone along its journal at which its rows at the gage reach `gage_radius`, m (see
/// ConeLayout::apex). Throws InputError when there is none: an offset beyond the gage, a cone too
/// large or too small for the bit. Needs a row at the gage.
double apex_for_gage(ConeLayout cone, double gage_radius);

}  // namespace tdbd::bit

#pragma once

namespace tdbd::forces {

/// A round cutter that moves along flat, uncut rock.
struct GrooveCutter {
  double diameter = 0.0;   ///< m, > 0
  double back_rake = 0.0;  ///< rad, within 80 degrees of 0
};

/// The depth of a groove and the number of Newton steps used to compute it.
struct GrooveDepth {
  double depth = 0.0;  ///< m
  int iterations = 0;
};

/// Area of a groove of the given depth (m), normal to the motion: a segment of the face, A = a^2 (t
/// - sin t cos t) cos b with depth = a (1 - cos t) cos b, a = diameter/2, b = back rake. For depths
/// of 2 a cos b and more it is the whole face. Glowka (1989), "virgin groove".
double groove_area(const GrooveCutter& cutter, double depth);

/// The inverse of groove_area: the depth of the groove in flat rock with the given cut area (m2, >=
/// 0). This is Glowka's effective depth of cut on rock that other cutters have cut before. Uses
/// Newton's method from below, which converges because t - sin t cos t is convex (the other half of
/// the face by symmetry): at most 5 steps, to rounding. For areas larger than the face it returns
/// the full depth.
GrooveDepth groove_depth(const GrooveCutter& cutter, double area);

}  // namespace tdbd::forces

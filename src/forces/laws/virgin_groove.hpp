#pragma once

namespace tdbd::forces {

/// A round cutter that moves along flat, uncut rock.
struct GrooveCutter {
  double diameter = 0.0;   ///< m, > 0
  double back_rake = 0.0;  ///< rad, within 80 degrees of 0
};

/// The depth of a groove, and the Newton steps that finding it took.
struct GrooveDepth {
  double depth = 0.0;  ///< m
  int iterations = 0;
};

/// Area of the cut, normal to the motion, of a groove of this depth (m): a segment of the face, A =
/// a^2 (t - sin t cos t) cos b with depth = a (1 - cos t) cos b, a = diameter/2, b = back rake.
/// From the depth 2 a cos b on, all of the face. Glowka (1989), "virgin groove".
double groove_area(const GrooveCutter& cutter, double depth);

/// The inverse: the depth of the groove in flat rock whose cut has this area (m2, >= 0), Glowka's
/// effective depth of cut on rock that other cutters have cut before. Newton's iteration from
/// below, which converges from there since t - sin t cos t is convex (the other half of the face by
/// symmetry): at most 5 steps, to rounding. Areas beyond the face's give its whole depth.
GrooveDepth groove_depth(const GrooveCutter& cutter, double area);

}  // namespace tdbd::forces

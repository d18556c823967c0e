#pragma once

#include <vector>

#include "core/types.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// A tooth's round end as rings of points, so that it also contacts ridges beside its tip. Ma, Zhou
/// and Deng discretise teeth and bottom "to represent the actual geometry" (thesis 2.2); the method
/// is not described. Our choice: every point contributes the slope of the force law at its own
/// depth times its share of the end's height. On flat rock the sum is the law itself, up to the
/// width of the rings; in the tooth's own crater it is zero.
struct RoundEnd {
  struct Point {
    double x = 0.0, y = 0.0;  ///< m, from the tooth's tip
    double rise = 0.0;        ///< m, above it
    double height = 0.0;      ///< m, share of the end's height that the point represents
  };
  std::vector<Point> points;
};

/// Makes rings of points `spacing` (m) apart, up to a height of `deepest` (m) on a sphere.
RoundEnd round_end(double sphere_radius, double spacing, double deepest);

/// Writes to `gaps` the depths of the bit at which the points make contact if the tooth's tip is at
/// `tip` (m, bit at depth 0). Returns the smallest.
double touch_round_end(const RoundEnd& end, const Vec3& tip, const ZMap& bottom, double* gaps);

/// Force, N, with the bit at depth z.
double round_end_force(const RoundEnd& end, const ToothLaw& law, const double* gaps, double z);

}  // namespace tdbd::reference

#pragma once

#include <vector>

#include "core/types.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// A tooth's round end as rings of points, so that it feels ridges beside its point. Ma, Zhou and Deng
/// discretise teeth and bottom "to represent the actual geometry" (thesis 2.2); how, nobody tells. Ours: every
/// point carries the slope of the force law at its own depth times its share of the end's height. On flat
/// rock the sum is the law itself up to the rings' width; in the tooth's own crater it is nothing.
struct RoundEnd {
  struct Point {
    double x = 0.0, y = 0.0;  ///< m, from the tooth's point
    double rise = 0.0;        ///< m, above it
    double height = 0.0;      ///< m, that the point stands for; their sum is the end's height
  };
  std::vector<Point> points;
};

/// Rings of points `spacing` (m) apart, up to a height of `deepest` (m) on a sphere.
RoundEnd round_end(double sphere_radius, double spacing, double deepest);

/// Depths of the bit at which the points touch when the tooth's point is at `tip` (m, bit at depth 0),
/// written to `gaps`; returns the least.
double touch_round_end(const RoundEnd& end, const Vec3& tip, const ZMap& bottom, double* gaps);

/// N, with the bit at depth z.
double round_end_force(const RoundEnd& end, const ToothLaw& law, const double* gaps, double z);

}  // namespace tdbd::reference

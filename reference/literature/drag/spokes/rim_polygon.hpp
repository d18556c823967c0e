#pragma once

#include <array>

#include "reference/literature/drag/spokes/spoke_path.hpp"
#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// A cutter's rim as a polygon of 64 corners, whose branches have theirs at the same radii. It lies in the ellipse:
/// at most 0.12 % of half the height within a branch.
inline constexpr int rim_slabs = 32;
struct RimPolygon {
  std::array<double, rim_slabs + 1> r, lower, upper;  ///< m, r rising
};

RimPolygon rim_polygon(const RimEllipse& rim);

/// Its corners as an outline with positive area; `out` is reused.
void outline_of(const RimPolygon& rim, Outline& out);

/// Exactly what of a piece of rock lies in the polygon: its area, its moment, and the length of the
/// polygon's lower branch in rock. No boolean: signed sums over the rock's edges.
CrossingCut rim_in_face(const RimPolygon& rim, const PlanarFace& rock);

}  // namespace tdbd::reference

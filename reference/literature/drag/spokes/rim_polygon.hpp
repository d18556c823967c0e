#pragma once

#include <array>

#include "reference/literature/drag/spokes/spoke_path.hpp"
#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// A cutter's rim as a polygon of 64 corners; both branches have corners at the same radii. It is
/// inscribed in the ellipse: a branch deviates by at most 0.12 % of half the height.
inline constexpr int rim_slabs = 32;
struct RimPolygon {
  std::array<double, rim_slabs + 1> r, lower, upper;  ///< m, r ascending
};

RimPolygon rim_polygon(const RimEllipse& rim);

/// Writes its corners as an outline with positive area to `out`, which is reused.
void outline_of(const RimPolygon& rim, Outline& out);

/// Computes exactly the part of a piece of rock that lies in the polygon: its area, its moment, and
/// the length of the polygon's lower branch in rock. Uses signed sums over the rock's edges, not
/// booleans.
CrossingCut rim_in_face(const RimPolygon& rim, const PlanarFace& rock);

}  // namespace tdbd::reference

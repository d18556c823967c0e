#pragma once

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {

/// How far one surface lies from another.
struct SurfaceDistance {
  double largest = 0.0;  ///< m: the one-sided Hausdorff distance, from below to within the spacing
  double volume = 0.0;   ///< m3: the integral of the distance over the surface
};

/// The distance of `from` to the surface in a tree, at points at most `spacing` (m) apart: every
/// corner, and the middles of equal parts of every triangle, which weigh for the integral. Zero for
/// an empty `from`; `to` must not be empty. Slow, obvious twin: reference::one_sided_hausdorff.
SurfaceDistance distance_to(const TriangleMesh& from, const TriangleTree& to, double spacing);

}  // namespace tdbd::mesh

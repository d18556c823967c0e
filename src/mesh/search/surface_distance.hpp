#pragma once

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {

/// Distance of one surface from another.
struct SurfaceDistance {
  double largest = 0.0;  ///< m: one-sided Hausdorff distance, a lower bound that is at most the
                         ///< spacing too small
  double volume = 0.0;   ///< m3: integral of the distance over the surface
};

/// Computes the distance of `from` to the surface in a tree at points at most `spacing` (m) apart:
/// at every corner, and at the centroids of equal parts of every triangle, which are the
/// integration points. Zero for an empty `from`; `to` must not be empty. Slow, simple twin:
/// reference::one_sided_hausdorff.
SurfaceDistance distance_to(const TriangleMesh& from, const TriangleTree& to, double spacing);

}  // namespace tdbd::mesh

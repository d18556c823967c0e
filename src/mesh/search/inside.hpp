#pragma once

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {

/// Whether x is inside a closed mesh. Counts the crossings of a ray; a ray that passes too close to an edge to be sure
/// is replaced by another, and finally by the winding number, so that no position is special. On the surface the answer
/// is arbitrary. Twin: reference::inside.
bool inside(const TriangleTree& closed, const Vec3& x);

/// Whether a facet is nearer to x than `distance` (m).
bool is_near(const TriangleTree& tree, const Vec3& x, double distance);

/// Distance from x to the nearest facet, m; infinite without facets.
double distance(const TriangleTree& tree, const Vec3& x);

/// The same where it is less than `most`, else `most`; faster.
double distance_up_to(const TriangleTree& tree, const Vec3& x, double most);

}  // namespace tdbd::mesh

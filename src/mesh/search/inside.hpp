#pragma once

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {

/// Whether x is inside a closed mesh. Counts the crossings of a ray. If a ray passes too close to
/// an edge, the next direction is tried, and after the last one the winding number decides, so that
/// every position gets a result. On the surface the result is arbitrary. Twin: reference::inside.
bool inside(const TriangleTree& closed, const Vec3& x);

/// Whether the distance from x to any facet is less than `distance` (m).
bool is_near(const TriangleTree& tree, const Vec3& x, double distance);

/// Distance from x to the closest facet, m; infinite without facets.
double distance(const TriangleTree& tree, const Vec3& x);

/// The distance if it is less than `most`, otherwise `most`. Faster than distance().
double distance_up_to(const TriangleTree& tree, const Vec3& x, double most);

}  // namespace tdbd::mesh

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Pairs of triangles (indices, smaller first, sorted) that intersect in more than a shared vertex
/// or edge, by CGAL's exact predicates. The rock's surface must have none (M4 in
/// src/rock/README.md). Throws RunError if the mesh is not an oriented manifold. The run time is
/// O(n log n) plus the number of pairs.
std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& m);

/// Number of such pairs.
std::size_t self_intersecting_pairs(const mesh::TriangleMesh& m);

}  // namespace tdbd::reference

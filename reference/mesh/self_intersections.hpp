#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Pairs of triangles (indices, smaller first, sorted) that intersect in more than the vertex or
/// edge that they share. By CGAL's exact predicates: the rock's surface must have none (M4 in src/rock/README.md).
/// Throws RunError if the mesh is not an oriented manifold. Cost: n log n plus the pairs.
std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& m);

/// How many such pairs there are.
std::size_t self_intersecting_pairs(const mesh::TriangleMesh& m);

}  // namespace tdbd::reference

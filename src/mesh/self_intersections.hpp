#pragma once

#include <utility>
#include <vector>

#include "mesh/check.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Pairs of triangles that meet in more than the corners and edges they share, first < second,
/// sorted, by exact predicates: what keeps a closed mesh from being a solid's boundary. Corners are
/// shared by place; two triangles with the same three corners are a pair, and triangles without
/// area are in none. Every index must be in range and every position finite.
std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh);

/// check_closed and, where that finds nothing, the pairs of self_intersections.
std::vector<Defect> check_solid(const TriangleMesh& m);

}  // namespace tdbd::mesh

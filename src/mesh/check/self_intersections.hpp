#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Pairs of triangles that meet in more than the corners and edges they share, first < second,
/// sorted, by exact predicates: what keeps a closed mesh from being a solid's boundary. Corners are
/// shared by place; two triangles with the same three corners are a pair, and triangles without
/// area are in none. Every index must be in range and every position finite.
std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh);

/// A triangle by the names of its corners, equal for the same corner, and their places, m.
struct NamedFacet {
  Triangle names{};
  std::array<Vec3, 3> x;
};

/// Whether two triangles meet in more than the corners and edges that they share by name, by exact
/// predicates. A triangle without area meets none.
bool intersect(const NamedFacet& first, const NamedFacet& second);

/// check_closed and, where that finds nothing, the pairs of self_intersections.
std::vector<Defect> check_solid(const TriangleMesh& m);

}  // namespace tdbd::mesh

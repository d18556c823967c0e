#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Pairs of triangles that meet in more than the corners and edges they share, first < second, sorted, by exact
/// predicates: a closed mesh with such pairs does not bound a solid. Corners at the same position are shared; two
/// triangles with the same three corners are a pair; triangles without area are in none. Indices must be in range and
/// positions finite.
std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh);

/// A triangle by the names of its corners, equal for the same corner, and their positions, m.
struct NamedFacet {
  Triangle names{};
  std::array<Vec3, 3> x;
};

/// Whether two triangles meet in more than the corners and edges that they share by name, by exact
/// predicates. A triangle without area meets no other.
bool intersect(const NamedFacet& first, const NamedFacet& second);

/// What check_closed finds, or, if it finds nothing, the pairs of self_intersections.
std::vector<Defect> check_solid(const TriangleMesh& m);

}  // namespace tdbd::mesh

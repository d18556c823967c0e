#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Splits a mesh into pieces. Facets are taken in order, and a piece ends as soon as it is closed.
/// Solids that touch or share points therefore stay separate if they were written one after the
/// other. Facets that never close are grouped by the edges they share. Two points are equal if
/// their coordinates are. Facets and points keep their order.
std::vector<TriangleMesh> divide(const TriangleMesh& m);

/// Returns the triangles of `m` with each vertex replaced by the first vertex at the same position.
std::vector<Triangle> by_first_of_equals(const TriangleMesh& m);

/// Returns the given triangles and the vertices they use, both in their original order.
TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles);

}  // namespace tdbd::mesh

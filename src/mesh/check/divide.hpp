#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Splits a mesh into pieces. Facets are taken in order; a piece ends as soon as it is closed, so that solids that touch
/// or share points stay apart if they were written one after the other. Facets that never close are grouped by the edges
/// they share. Points count as equal when their coordinates are. Facets and points keep their order.
std::vector<TriangleMesh> divide(const TriangleMesh& m);

/// The triangles with each vertex replaced by the first vertex at the same place.
std::vector<Triangle> by_first_of_equals(const TriangleMesh& m);

/// The given triangles with the vertices that they use, both in their order.
TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles);

}  // namespace tdbd::mesh

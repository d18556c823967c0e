#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// The numbers of points, by the cube with edges of `cube` (m) that holds a point, and in a cube by
/// its 64 cells.
std::vector<int> order_of_space(const std::vector<Vec3>& points, double cube);

/// The same mesh, its vertices numbered in that order, its triangles by their least vertex. What a
/// step reads together then lies together in memory: of a borehole's own order, ring after ring, a
/// cutter needs a few vertices of many rings.
mesh::TriangleMesh in_order_of_space(const mesh::TriangleMesh& m, double cube);

}  // namespace tdbd::rock

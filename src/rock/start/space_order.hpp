#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// Returns the indices of points sorted by the cube, with edges of `cube` (m), that contains the
/// point, and within a cube by its 64 cells.
std::vector<int> order_of_space(const std::vector<Vec3>& points, double cube);

/// Returns the same mesh with its vertices numbered in that order and its triangles sorted by their
/// smallest vertex. Data that a step reads together are then close together in memory. In a
/// borehole's original order, ring after ring, a cutter needs a few vertices of many rings.
mesh::TriangleMesh in_order_of_space(const mesh::TriangleMesh& m, double cube);

/// A vertex, its cell in that order, and its offset along x in that cell, in 2^-32 cells.
struct PlacedVertex {
  std::uint64_t cell;
  std::uint32_t along;
  int v;
};

/// Returns the living vertices of a surface in that order; those of a cell are sorted by x, y and
/// z. The order depends only on the surface's shape, not on the numbers of its vertices, except for
/// vertices at the same point. `placed`: a reused buffer.
void order_of_space(const mesh::Surface& s, double cube, std::vector<PlacedVertex>& placed,
                    std::vector<int>& order);

}  // namespace tdbd::rock

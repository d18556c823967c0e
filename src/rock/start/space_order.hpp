#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// The numbers of points, by the cube with edges of `cube` (m) that holds a point, and in a cube by
/// its 64 cells.
std::vector<int> order_of_space(const std::vector<Vec3>& points, double cube);

/// The same mesh, its vertices numbered in that order, its triangles by their least vertex. What a
/// step reads together then lies together in memory: of a borehole's own order, ring after ring, a
/// cutter needs a few vertices of many rings.
mesh::TriangleMesh in_order_of_space(const mesh::TriangleMesh& m, double cube);

/// A vertex, its cell in that order, and how far along x it lies there, in 2^-32 cells.
struct PlacedVertex {
  std::uint64_t cell;
  std::uint32_t along;
  int v;
};

/// The living vertices of a surface in that order, those of a cell by x, y and z: the order
/// follows from the surface's shape, whatever its numbers are; only vertices at the same point keep
/// the order of theirs. `placed`: room, kept between calls so that none allocates once warm.
void order_of_space(const mesh::Surface& s, double cube, std::vector<PlacedVertex>& placed,
                    std::vector<int>& order);

}  // namespace tdbd::rock

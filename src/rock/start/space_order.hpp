#pragma once

#include <cstdint>
#include <vector>

#include "mesh/edit.hpp"
#include "mesh/surface.hpp"
#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"

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

/// Buffers of renumber(), kept between calls to avoid allocations.
struct RenumberWork {
  std::vector<PlacedVertex> placed;
  std::vector<int> order, parts;
  std::vector<MovedIn> moved_in;
  std::vector<VertexGrid::Block> blocks;
  mesh::RenumberScratch mesh;
};

/// Renumbers the rock's vertices and triangles by place, in cubes with edges of `cube` (m), and
/// sorts its index in the same order. Data that a step reads together are then close together in
/// memory again; before, new vertices had taken any free number. Not in the thesis. The surface,
/// its marks and the waiting vertices do not change. The new numbers depend only on the shape, so a
/// copy with other numbers gets the same ones. Maintenance resolves ties by number, so later
/// results may differ in details.
void renumber(Rock& rock, double cube, RenumberWork& work);

}  // namespace tdbd::rock

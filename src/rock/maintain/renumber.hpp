#pragma once

#include <cstdint>
#include <vector>

#include "mesh/renumber.hpp"
#include "rock/rock.hpp"
#include "rock/start/space_order.hpp"

namespace tdbd::rock {

/// Buffers of renumber(), kept between calls to avoid allocations.
struct RenumberWork {
  std::vector<PlacedVertex> placed;
  std::vector<int> order, parts;
  std::vector<MovedIn> moved_in;
  std::vector<VertexGrid::Block> blocks;
  mesh::RenumberRoom mesh;
};

/// Renumbers the rock's vertices and triangles by place, in cubes with edges of `cube` (m), and
/// sorts its index in the same order. Data that a step reads together are then close together in
/// memory again; before, new vertices had taken any free number. Not in the thesis. The surface,
/// its marks and the waiting vertices do not change. The new numbers depend only on the shape, so a
/// copy with other numbers gets the same ones. Maintenance resolves ties by number, so later
/// results may differ in details.
void renumber(Rock& rock, double cube, RenumberWork& work);

}  // namespace tdbd::rock

#pragma once

#include <cstdint>
#include <vector>

#include "mesh/renumber.hpp"
#include "rock/rock.hpp"
#include "rock/start/space_order.hpp"

namespace tdbd::rock {

/// Room for renumberings, kept between them so that none allocates once warm.
struct RenumberWork {
  std::vector<PlacedVertex> placed;
  std::vector<int> order, parts;
  std::vector<MovedIn> moved_in;
  std::vector<VertexGrid::Block> blocks;
  mesh::RenumberRoom mesh;
};

/// Numbers the rock's vertices and triangles by place, in cubes with edges of `cube` (m), and puts
/// its index into the same order: what a step reads together lies together in memory again, where
/// new vertices had taken whatever number was free (ours). The surface, its marks and what waits
/// stay as they are. The numbers follow from the shape alone: a copy with other numbers gets the
/// same. Ties of maintenance are decided by number, so what follows may differ in details.
void renumber(Rock& rock, double cube, RenumberWork& work);

}  // namespace tdbd::rock

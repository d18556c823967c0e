#pragma once

#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Calls visit(v) for every vertex that the grid offers for a region.
template <class Visit>
void visit_vertices(const VertexGrid& grid, const Region& region, Visit&& visit) {
  std::vector<int> chains;
  grid.visit(region, chains, [&](const VertexGrid::Block& block) {
    for (int s = 0; s < block.count; ++s) visit(block.v[static_cast<std::size_t>(s)]);
  });
}

}  // namespace tdbd::rock

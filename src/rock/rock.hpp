#pragma once

#include <vector>

#include "mesh/surface.hpp"
#include "rock/index/near_list.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// The rock: a surface whose normal points out of the rock, an index over its vertices, lists of
/// those near the bit, who cut each vertex last, and which vertices changed since the last
/// maintenance. Frame W. Thesis: 4.1.
struct Rock {
  mesh::Surface surface;
  VertexGrid grid;
  std::vector<int> last_part;         ///< per vertex: index into Bit::parts, -1 untouched
  std::vector<std::uint8_t> touched;  ///< per vertex: a mark if listed in touched_list
  std::vector<int> touched_list;
  std::vector<NearList> near_lists;  ///< of the groups of the bit that cut last
};

/// Puts a surface under the index. `cell` in m; about twice the edge length is quickest.
/// `reach_W` is where the bit will go, so that the grid covers it.
Rock make_rock(mesh::Surface surface, double cell, const mesh::Box& reach_W);

/// Marks of Rock::touched. The second only during a maintenance: looked at, and not touched since
/// (touched_region.hpp).
inline constexpr std::uint8_t touched_mark = 1, looked_at_mark = 2;

/// Notes that a vertex changed (moved, or its triangles did).
void touch(Rock& rock, int v);

/// Puts vertex v to x_W, and notes that it and its triangles changed.
void place_vertex(Rock& rock, int v, const Vec3& x_W);

/// Grows the per-vertex arrays and the index after a bisection made vertex v.
void register_vertex(Rock& rock, int v, int last_part);

}  // namespace tdbd::rock

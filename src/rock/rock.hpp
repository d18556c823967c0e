#pragma once

#include <vector>

#include "mesh/surface.hpp"
#include "rock/index/near_list.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// The first and the last cut that moved a vertex since it was last off Rock::touched_list.
struct MovedIn {
  static constexpr int never = -1'000'000'000;
  int first = never, last = never;
};

/// The rock: a surface whose normal points out of the rock, an index of its vertices, lists of
/// those near the bit, the part that cut each vertex last and when it did, and the vertices that
/// changed and have not been maintained since. Frame W. Thesis: 4.1.
struct Rock {
  mesh::Surface surface;
  VertexGrid grid;
  std::vector<int> last_part;         ///< per vertex: index into Bit::parts, -1 untouched
  std::vector<std::uint8_t> touched;  ///< per vertex: a mark if listed in touched_list
  std::vector<int> touched_list;
  int cuts = 0;                      ///< calls of cut_rock so far
  std::vector<MovedIn> moved_in;     ///< per vertex, in counts of `cuts`
  std::vector<NearList> near_lists;  ///< per group of the bit that cut last
};

/// Builds the index of a surface. `cell`: m; about twice the edge length is quickest. `reach_W`:
/// where the bit will go, so that the grid covers it.
Rock make_rock(mesh::Surface surface, double cell, const mesh::Box& reach_W);

/// Makes the index anew, about `box_W` and with cells as large. Cuts and repairs stay the same.
void make_index_anew(Rock& rock, const mesh::Box& box_W);

/// Makes the index anew, as deep again as the rock is high, if the hole has become deeper than the
/// index's box by some cells: one layer would hold all that is below it.
void deepen_index(Rock& rock);

/// Marks of Rock::touched. The second appears only during a maintenance: classified, and not
/// touched since (touched_region.hpp).
inline constexpr std::uint8_t touched_mark = 1, classified_mark = 2;

/// Notes that a vertex changed: it moved, or its triangles changed.
void touch(Rock& rock, int v);

/// Notes that the neighbours of v changed.
void touch_neighbours(Rock& rock, int v);

/// Moves vertex v to x_W on the surface and in the index, and notes that it changed. `teller`: of the
/// near lists.
void place_vertex(Rock& rock, int v, const Vec3& x_W, Teller teller = Teller::journal);

/// Notes that the cut at work moves vertex v; to be called before it is touched. What maintenance
/// moves is not noted: it does not wait for its own moves.
void note_cut(Rock& rock, int v);

/// Whether the last cut moved vertex v. Until the next maintenance.
inline bool is_moved_now(const Rock& rock, int v) { return rock.moved_in[at(v)].last == rock.cuts; }

/// Extends the per-vertex arrays and the index after a bisection made vertex v.
void register_vertex(Rock& rock, int v, int last_part);

}  // namespace tdbd::rock

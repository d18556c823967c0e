#pragma once

#include <algorithm>
#include <vector>

#include "core/wide.hpp"
#include "rock/index/near_region.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Balls around places, m, in columns padded to whole packs with balls that are nowhere (NaN).
struct Balls {
  std::vector<Single> x, y, z, radius;
};

/// Eight balls side by side.
struct WideBalls {
  WideSingle x, y, z, radius;
};

/// The balls from i on. For loops that are TDBD_WIDE.
inline void load(const Balls& balls, std::size_t i, WideBalls& wide) {
  TDBD_LOAD(wide.x, &balls.x[i]);
  TDBD_LOAD(wide.y, &balls.y[i]);
  TDBD_LOAD(wide.z, &balls.z[i]);
  TDBD_LOAD(wide.radius, &balls.radius[i]);
}

/// Stands in a list for a vertex that is no more; its place is nowhere.
inline constexpr int no_vertex = -1;

/// The rock vertices of a region side by side in memory, for the steps in which a group of parts
/// stays there: the index is queried once in several steps, and later searches near the group read
/// only this short list (a Verlet list of molecular dynamics, ours). What changes meanwhile is told
/// by the index's journal or by the mover. Places are rounded to single precision: they serve to
/// reject vertices. A place may be out of date where a vertex has left the region; take the position
/// of a vertex from the surface. Eight places are a pack, and a ball around each pack tells which
/// packs to read.
struct NearList {
  Region region_W;  ///< all vertices between its slabs, which are orthogonal, are in the list
  Vec3 origin_W = Vec3::Zero();  ///< of the places; exact in single precision
  std::vector<Single> x, y, z;   ///< m; padded to whole packs with places that are nowhere
  std::vector<int> v;            ///< each vertex once; no_vertex where one was removed
  Balls balls;                   ///< of the packs
  std::vector<int> slots;        ///< a table of places by vertex (list_places.hpp)
  std::vector<int> chains;
  long changes = -1;      ///< count of the index's changes that the list includes
  int window = 0;         ///< steps for which the region was made
  double way_left = 0.0;  ///< m, that the group may still go before the region ends too near ahead
  std::size_t size_when_made = 0;
};

/// Whether the list holds all vertices of the index between the region's slabs, which are
/// orthogonal.
bool covers(const NearList& list, const VertexGrid& grid, const Region& region_W);

/// Makes the list cover the step and brings it up to date from the index's journal. It is made again
/// from the index, for a region ahead along the screw motion of the step, if the step leaves its
/// region, if the group has come so far that the region no longer extends `margins.ahead` beyond it,
/// if the journal does not reach back to it, or if it has grown to twice its size.
void bring_up_to_date(const VertexGrid& grid, const GroupStep& step, const NearListMargins& margins,
                      NearList& list);

inline bool is_between(const std::array<Slab, 3>& slabs, const Vec3& x_W) {
  return std::ranges::all_of(slabs, [&](const Slab& s) {
    const double along = s.n.dot(x_W);
    return along >= s.lo && along <= s.hi;
  });
}

/// The list's vertex number i has moved to x_W.
void set_place(NearList& list, std::size_t i, const Vec3& x_W);

/// Vertices, in the list or not, changed. Once all changes are noted, the list's `changes` may be set
/// to the index's.
void note_changes(NearList& list, const VertexChanges& changes);

/// Appends the vertices between the slabs of the region widened by `slack` (m), in the order of
/// the list.
void add_vertices_between(const NearList& list, const Region& region_W, double slack,
                          std::vector<int>& vertices);

}  // namespace tdbd::rock

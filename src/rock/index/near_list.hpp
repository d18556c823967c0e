#pragma once

#include <algorithm>
#include <vector>

#include "core/wide.hpp"
#include "rock/index/near_region.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Balls around places, m, as columns padded to whole packs with NaN.
struct Balls {
  std::vector<Single> x, y, z, radius;
};

/// Eight balls, one per lane.
struct WideBalls {
  WideSingle x, y, z, radius;
};

/// Loads eight balls from i on. For loops that are TDBD_WIDE.
inline void load(const Balls& balls, std::size_t i, WideBalls& wide) {
  TDBD_LOAD(wide.x, &balls.x[i]);
  TDBD_LOAD(wide.y, &balls.y[i]);
  TDBD_LOAD(wide.z, &balls.z[i]);
  TDBD_LOAD(wide.radius, &balls.radius[i]);
}

/// Marks a removed vertex in a list; its place is `nowhere`.
inline constexpr int no_vertex = -1;

/// The rock vertices of a region, contiguous in memory, for the steps in which a group of parts
/// stays there (a Verlet list as in molecular dynamics; not in the thesis). The index is queried
/// once for several steps; other searches near the group read only this short list. Changes in
/// between come from the index's journal or from the code that moved the vertices. Places are
/// rounded to single precision and serve only to reject vertices. The place of a vertex that has
/// left the region may be out of date; read its position from the surface. Eight places form a
/// pack. A ball around each pack shows whether the pack must be read.
struct NearList {
  Region region_W;               ///< contains all vertices between its slabs, which are orthogonal
  Vec3 origin_W = Vec3::Zero();  ///< origin of the places; exact in single precision
  std::vector<Single> x, y, z;   ///< m; padded to whole packs with `nowhere`
  std::vector<int> v;            ///< each vertex at most once; no_vertex where one was removed
  Balls balls;                   ///< of the packs
  std::vector<int> slots;        ///< hash table of places by vertex (list_places.hpp)
  std::vector<int> chains;
  long changes = -1;      ///< number of the index's changes that are included
  int window = 0;         ///< number of steps for which the region was made
  double way_left = 0.0;  ///< m that the group may move before the region ends too close ahead
  std::size_t size_when_made = 0;
};

/// Whether the list contains all vertices of the index between the region's slabs, which are
/// orthogonal.
bool covers(const NearList& list, const VertexGrid& grid, const Region& region_W);

/// Updates the list from the index's journal so that it covers the step. The list is rebuilt from
/// the index, for a region ahead along the screw motion of the step, if one of these holds: the
/// step leaves the region; the region no longer extends `margins.ahead` beyond the group; the
/// journal does not contain all changes since the list was made; the list has grown to twice its
/// size.
void bring_up_to_date(const VertexGrid& grid, const GroupStep& step, const NearListMargins& margins,
                      NearList& list);

inline bool is_between(const std::array<Slab, 3>& slabs, const Vec3& x_W) {
  return std::ranges::all_of(slabs, [&](const Slab& s) {
    const double along = s.n.dot(x_W);
    return along >= s.lo && along <= s.hi;
  });
}

/// Records that the vertex at place i of the list moved to x_W.
void set_place(NearList& list, std::size_t i, const Vec3& x_W);

/// Applies changes of vertices, whether or not they are in the list. After all changes have been
/// applied, the caller may set `changes` of the list to that of the index.
void note_changes(NearList& list, const VertexChanges& changes);

/// Appends the vertices between the slabs of the region widened by `slack` (m), in the order of the
/// list.
void add_vertices_between(const NearList& list, const Region& region_W, double slack,
                          std::vector<int>& vertices);

}  // namespace tdbd::rock

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/simd.hpp"
#include "core/types.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// How far lists extend beyond the region that the steps need, for later queries. m.
struct NearListMargins {
  double margin = 0.0;  ///< all around the group
  double ahead = 0.0;   ///< along the group's path
};

/// The motion of a group in a step: its box, its poses at the start and end, and the required
/// region.
struct GroupStep {
  const mesh::Box& box_P;
  const Pose &X_WP0, &X_WP1;
  const Region& region_W;
};

/// How far the middle of the group's box moves in the step, m.
double travel_in_step(const GroupStep& step);

/// Whether the slabs of `region_W` contain everything between the slabs of `part_W`, which are
/// orthogonal.
bool holds(const Region& region_W, const Region& part_W);

/// The region of the group for the next `steps` steps and `margins.ahead` beyond, if its motion
/// continues as in this step. Limited to a rotation of three quarters of a radian.
Region region_ahead(const GroupStep& step, const NearListMargins& margins, int steps);

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
  std::vector<int> slots;        ///< hash table of places by vertex (place_of)
  std::vector<int> chains;
  long changes = -1;  ///< number of the index's changes that are included
  int window = 0;     ///< number of steps for which the region was made
  double remaining_travel =
      0.0;  ///< m that the group may move before the region ends too close ahead
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
void update_near_list(const VertexGrid& grid, const GroupStep& step, const NearListMargins& margins,
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

/// Slabs in single precision, relative to an origin.
struct SingleSlabs {
  std::array<Single, 3> nx{}, ny{}, nz{}, lo{}, hi{};
};

/// The slabs relative to an origin, widened by `slack` (m).
SingleSlabs about(const Vec3& origin_W, const std::array<Slab, 3>& slabs, double slack);

/// Eight places, one per lane.
struct WidePoints {
  WideSingle x, y, z;
};

/// Loads the places of a block of the index. Its columns are read as eight entries; the eighth is
/// meaningless.
inline void load(const VertexGrid::Block& block, WidePoints& p) {
  using Block = VertexGrid::Block;
  const char* bytes = reinterpret_cast<const char*>(&block);
  TDBD_LOAD(p.x, bytes + offsetof(Block, x));
  TDBD_LOAD(p.y, bytes + offsetof(Block, y));
  TDBD_LOAD(p.z, bytes + offsetof(Block, z));
  p.z[VertexGrid::block_size] = 0;  // a vertex number read as a subnormal would be slow
}

/// Flags the places that lie between all slabs. A place that is `nowhere` is not flagged. For loops
/// that are TDBD_WIDE.
inline void flag_between(const WidePoints& p, const SingleSlabs& s, WideFlags& in) {
  in = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle along = s.nx[k] * p.x + s.ny[k] * p.y + s.nz[k] * p.z;
    in &= (along >= s.lo[k]) & (along <= s.hi[k]);
  }
}

/// Makes room for this many places and one pack more. Does not preserve the contents.
void make_room(NearList& list, std::size_t places);

/// Completes a list after its first `places` places were written: pads them to whole packs,
/// computes the balls around the packs, and discards the table of places.
void close(NearList& list, std::size_t places);

/// Returned by place_of if a vertex is not in the list.
inline constexpr std::size_t no_place = ~std::size_t{0};

/// Returns the place of vertex v, or no_place if it is not in the list. The first call after the
/// list was made fills its hash table (open addressing, linear probing, at least two slots per
/// vertex).
std::size_t place_of(NearList& list, int v);

/// Appends a vertex that is not yet in the list.
void append(NearList& list, int v, const Vec3& x_W);

/// Removes the vertex at a place from the list.
void take_out(NearList& list, std::size_t i);

}  // namespace tdbd::rock

#pragma once

#include <algorithm>
#include <vector>

#include "core/pose.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Balls around places, m, in columns that are padded to whole packs with balls that are nowhere.
struct Balls {
  std::vector<Single> x, y, z, radius;
};

/// The rock vertices of a region side by side in memory, for the steps in which a group of parts
/// stays there: the index is asked once in several steps, and everything near the group is then
/// looked for in this short list (a Verlet list of molecular dynamics, ours). Places are rounded to
/// single precision: they serve to turn vertices away. A place may be out of date where a vertex
/// has left the region; whoever takes a vertex from here asks the surface where it is. Eight places
/// are a pack, and a ball around each pack tells first which packs need a look.
struct NearList {
  Region region_W;               ///< all vertices between its slabs are here; they are orthogonal
  Vec3 origin_W = Vec3::Zero();  ///< of the places
  std::vector<Single> x, y, z;   ///< m; padded to whole packs with places that are nowhere
  std::vector<int> v;            ///< each vertex once
  Balls balls;                   ///< of the packs
  std::vector<int> chains;
  long changes = -1;     ///< of the index, that the list knows of
  int window = 0;        ///< steps for which the region was made
  int since_change = 0;  ///< steps since the index was changed by others than the step
};

/// How far the lists reach beyond what the steps need, for those who ask after them. Lengths in m.
struct Foresight {
  double margin = 0.0;  ///< all around the group
  double ahead = 0.0;   ///< along the group's way
};

/// What a group does in a step: its box, its poses at begin and end, and the region that it needs.
struct GroupStep {
  const mesh::Box& box_P;
  const Pose &X_WP0, &X_WP1;
  const Region& region_W;
};

/// Whether the list holds all vertices of the index between the region's slabs, which are
/// orthogonal.
bool covers(const NearList& list, const VertexGrid& grid, const Region& region_W);

/// Makes the list cover the step; asks the index only if it does not yet. Then it looks ahead along
/// the screw motion of the step, as many steps as were possible last time.
void bring_up_to_date(const VertexGrid& grid, const GroupStep& step, const Foresight& foresight,
                      NearList& list);

inline bool is_between(const std::array<Slab, 3>& slabs, const Vec3& x_W) {
  return std::ranges::all_of(slabs, [&](const Slab& s) {
    const double along = s.n.dot(x_W);
    return along >= s.lo && along <= s.hi;
  });
}

/// The list's vertex number i has come to this place.
void set_place(NearList& list, std::size_t i, const Vec3& x_W);

/// A vertex has come to this place between the list's slabs, known to it or not. Then the list's
/// `changes` may be set to the index's.
void note_moved(NearList& list, int v, const Vec3& x_W);

/// Appends the vertices between the slabs of the region widened by `slack` (m), in the order of
/// the list.
void add_vertices_between(const NearList& list, const Region& region_W, double slack,
                          std::vector<int>& vertices);

}  // namespace tdbd::rock

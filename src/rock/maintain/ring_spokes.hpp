#pragma once

#include "core/wide.hpp"
#include "mesh/surface.hpp"

namespace tdbd::rock {

/// @file
/// The triangles around a vertex as columns in single precision, tested eight at a time. For closed
/// rings of at most eight neighbours.

/// One value per triangle; the values are repeated behind the last one. Not initialized, because
/// only stored entries are loaded.
struct alignas(32) RingColumn {
  Single at[2 * single_lanes];
};

/// One flag per triangle, all bits set or none; repeated behind the last one.
struct alignas(32) RingFlags {
  int at[2 * single_lanes];
};

/// Vectors from the vertex to its neighbours, m. Triangle i has the spokes i and i + 1.
struct Spokes {
  RingColumn x, y, z;
};

/// The two spokes of eight triangles, one triangle per lane.
struct WideSpokes {
  WideSingle ex, ey, ez, fx, fy, fz;
};

/// Loads the spokes. For functions that are TDBD_WIDE.
[[gnu::always_inline]] inline void load(const Spokes& d, WideSpokes& w) {
  TDBD_LOAD(w.ex, d.x.at);
  TDBD_LOAD(w.ey, d.y.at);
  TDBD_LOAD(w.ez, d.z.at);
  TDBD_LOAD(w.fx, d.x.at + 1);
  TDBD_LOAD(w.fy, d.y.at + 1);
  TDBD_LOAD(w.fz, d.z.at + 1);
}

/// Stores the first of n values again behind the last one.
[[gnu::always_inline]] inline void wrap(RingColumn& c, std::size_t n) { c.at[n] = c.at[0]; }

inline bool has_spokes(const mesh::VertexStar& star) {
  return star.open == 0 && star.long_ring < 0;
}

[[gnu::always_inline]] inline void find_spokes(const mesh::Surface& s, const mesh::VertexStar& star,
                                               Spokes& d) {
  const std::size_t n = star.size;
  const WideSingle none = {};
  for (RingColumn* c : {&d.x, &d.y, &d.z}) {
    TDBD_STORE(none, c->at);
    TDBD_STORE(none, c->at + single_lanes);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 spoke = s.position(star.ring[i]) - star.x;
    d.x.at[i] = static_cast<Single>(spoke.x());
    d.y.at[i] = static_cast<Single>(spoke.y());
    d.z.at[i] = static_cast<Single>(spoke.z());
  }
  for (RingColumn* c : {&d.x, &d.y, &d.z}) wrap(*c, n);
}

}  // namespace tdbd::rock

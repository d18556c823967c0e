#pragma once

#include "core/wide.hpp"
#include "mesh/surface.hpp"

namespace tdbd::rock {

/// @file
/// The triangles around a vertex side by side in single precision, to be sifted eight at once. For
/// closed rings of at most eight neighbours.

/// A figure of each triangle, repeated behind the last. Not initialized: only what was stored is
/// loaded.
struct alignas(32) RingColumn {
  Single at[2 * single_lanes];
};

/// A flag of each triangle, repeated behind the last: all bits set or none.
struct alignas(32) RingFlags {
  int at[2 * single_lanes];
};

/// The neighbours less the vertex, m: triangle i has the spokes i and i + 1.
struct Spokes {
  RingColumn x, y, z;
};

/// A triangle's two spokes, eight triangles side by side.
struct WideSpokes {
  WideSingle ex, ey, ez, fx, fy, fz;
};

/// For functions that are TDBD_WIDE.
[[gnu::always_inline]] inline void load(const Spokes& d, WideSpokes& w) {
  TDBD_LOAD(w.ex, d.x.at);
  TDBD_LOAD(w.ey, d.y.at);
  TDBD_LOAD(w.ez, d.z.at);
  TDBD_LOAD(w.fx, d.x.at + 1);
  TDBD_LOAD(w.fy, d.y.at + 1);
  TDBD_LOAD(w.fz, d.z.at + 1);
}

/// Repeats the first figure of n behind the last.
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

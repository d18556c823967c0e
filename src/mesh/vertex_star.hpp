#pragma once

#include <array>
#include <cstdint>

#include "core/types.hpp"

namespace tdbd::mesh {

/// A vertex and its neighbours in one cache line: the data of the surface that a step reads. The
/// neighbours are in counter-clockwise order. The triangles at vertex v are (v, ring[i], ring[i +
/// 1]), and the last neighbour with the first unless the ring is open. A closed ring starts with
/// its smallest index, an open one at the boundary, so a star depends on the connectivity only, not
/// on the edits that led to it. Rings of more than `held` neighbours are stored by the surface
/// (Surface::ring).
struct alignas(64) VertexStar {
  static constexpr int held = 8;
  Vec3 x = Vec3::Zero();         ///< m
  std::array<int, held> ring{};  ///< neighbours, if there are at most `held`
  std::uint32_t size : 31 = 0;   ///< number of neighbours; 0: the vertex is dead
  std::uint32_t open : 1 = 0;    ///< 1 on the boundary
  std::int32_t long_ring = -1;   ///< index into Surface::long_rings, or -1

  /// For checkpoints: the neighbours follow from the triangles (refresh_stars).
  template <class Archive>
  void serialize(Archive& a) {
    a(x);
  }
};

static_assert(sizeof(VertexStar) == 64);

struct Surface;

/// Recomputes the star of a vertex from the corner table. Every edit must call it for the vertices
/// whose triangles it changed.
void refresh_star(Surface& s, int v);

/// Recomputes the stars of all vertices.
void refresh_stars(Surface& s);

/// Whether every star equals the result of refresh_star. Slow; for tests and debug builds.
bool stars_are_right(const Surface& s);

}  // namespace tdbd::mesh

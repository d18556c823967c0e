#pragma once

#include <array>
#include <cstdint>

#include "core/types.hpp"

namespace tdbd::mesh {

/// A vertex and its neighbours in one cache line: what a step reads of the surface. The neighbours come counter-clockwise;
/// the triangles at the vertex v are (v, ring[i], ring[i + 1]), and the last with the first unless the ring is open. A
/// closed ring begins with its smallest number, an open one at the boundary, so a star depends on the connectivity alone,
/// not on the edits that led to it. Rings of more than `held` neighbours are kept by the surface (Surface::ring).
struct alignas(64) VertexStar {
  static constexpr int held = 8;
  Vec3 x = Vec3::Zero();         ///< m
  std::array<int, held> ring{};  ///< neighbours, if there are at most `held`
  std::uint32_t size : 31 = 0;   ///< number of neighbours; 0: the vertex is dead
  std::uint32_t open : 1 = 0;    ///< 1 on the boundary
  std::int32_t long_ring = -1;   ///< index into Surface::long_rings, or -1
};

static_assert(sizeof(VertexStar) == 64);

struct Surface;

/// Makes the star of a vertex anew from the corner table. Every edit calls it for the vertices whose triangles it
/// changed.
void refresh_star(Surface& s, int v);

/// The same for all vertices.
void refresh_stars(Surface& s);

/// Whether every star is what refresh_star would make it. Slow; for tests and debug builds.
bool stars_are_right(const Surface& s);

}  // namespace tdbd::mesh

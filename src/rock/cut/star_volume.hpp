#pragma once

#include "mesh/surface.hpp"

namespace tdbd::rock {

/// Returns the volume, m3, by which the hole grows when vertex v of a surface, not on its boundary,
/// moves by d. Positive against the normal (rock removed), rock (10). Around a closed ring it is
/// linear in d, so it is exact for a vertex that moves alone. The sum over vertices moved one after
/// another is the exact change. Thesis: 4.3 (prisms; twin: reference/rock/prism).
inline double star_volume(const mesh::Surface& s, int v, const Vec3& d) {
  const mesh::VertexStar& star = s.star(v);
  const int* ring = s.ring(star);
  const Vec3 first = s.position(ring[0]) - star.x;
  Vec3 doubled_area = Vec3::Zero(), e = first;
  for (int i = 1; i < star.size; ++i) {
    const Vec3 next = s.position(ring[i]) - star.x;
    doubled_area += e.cross(next);
    e = next;
  }
  doubled_area += e.cross(first);
  return -doubled_area.dot(d) / 6.0;
}

}  // namespace tdbd::rock

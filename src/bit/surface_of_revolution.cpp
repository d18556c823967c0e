#include "bit/surface_of_revolution.hpp"

#include <cmath>

#include "core/types.hpp"

namespace tdbd::bit {
namespace {

Vec3 ring_point(const Ring& ring, int k) {
  if (ring.count == 1) return {ring.x, 0.0, 0.0};
  const double angle = full_turn * k / ring.count;
  return {ring.x, ring.radius * std::sin(angle), -ring.radius * std::cos(angle)};
}

/// Triangles between a ring of na points that starts at index a and the next ring, nb points from
/// b.
void stitch(int a, int na, int b, int nb, std::vector<mesh::Triangle>& triangles) {
  const int steps_a = na == 1 ? 0 : na, steps_b = nb == 1 ? 0 : nb;
  for (int i = 0, j = 0; i < steps_a || j < steps_b;) {
    const bool advance_b = i == steps_a || (j < steps_b && (j + 1) * na <= (i + 1) * nb);
    const int at_a = a + i % na, at_b = b + j % nb;
    if (advance_b)
      triangles.push_back({at_a, at_b, b + ++j % nb});
    else
      triangles.push_back({at_a, at_b, a + ++i % na});
  }
}

}  // namespace

mesh::TriangleMesh surface_of_revolution(const std::vector<Ring>& rings) {
  mesh::TriangleMesh m;
  int previous_start = 0, previous_count = 0;
  for (const Ring& ring : rings) {
    const int start = static_cast<int>(m.positions.size());
    for (int k = 0; k < ring.count; ++k) m.positions.push_back(ring_point(ring, k));
    if (previous_count > 0) stitch(previous_start, previous_count, start, ring.count, m.triangles);
    previous_start = start;
    previous_count = ring.count;
  }
  return m;
}

}  // namespace tdbd::bit

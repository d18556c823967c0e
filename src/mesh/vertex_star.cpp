#include "mesh/vertex_star.hpp"

#include <algorithm>
#include <span>

#include "core/error.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {
namespace {

/// The corner at v from which turning left reaches all others.
int first_corner(const Surface& s, int v) {
  int c = s.corner_of[at(v)];
  if (!s.is_boundary(v)) return c;
  for (int right = turn_right(s, c); right >= 0; right = turn_right(s, c)) c = right;
  return c;
}

/// Calls visit(neighbour) counter-clockwise; an open ring starts at its beginning.
template <class Visit>
void visit_ring(const Surface& s, int v, Visit&& visit) {
  const int first = first_corner(s, v);
  int c = first, last = first;
  do {
    visit(s.vertex(next_corner(c)));
    last = c;
    c = turn_left(s, c);
  } while (c >= 0 && c != first);
  if (c < 0) visit(s.vertex(previous_corner(last)));
}

void free_long_ring(Surface& s, VertexStar& star) {
  if (star.long_ring < 0) return;
  s.free_long_rings.push_back(star.long_ring);
  star.long_ring = -1;
}

int new_long_ring(Surface& s) {
  if (s.free_long_rings.empty()) {
    s.long_rings.emplace_back();
    return static_cast<int>(s.long_rings.size()) - 1;
  }
  const int number = s.free_long_rings.back();
  s.free_long_rings.pop_back();
  return number;
}

/// Storage for the neighbours of a star: in the star itself or among the long rings.
std::span<int> room_for(Surface& s, VertexStar& star, int size) {
  star.ring.fill(0);
  if (size <= VertexStar::held) return {star.ring.data(), static_cast<std::size_t>(size)};
  star.long_ring = new_long_ring(s);
  std::vector<int>& ring = s.long_rings[at(star.long_ring)];
  ring.resize(static_cast<std::size_t>(size));
  return ring;
}

}  // namespace

void refresh_star(Surface& s, int v) {
  VertexStar& star = s.stars[at(v)];
  free_long_ring(s, star);
  int size = 0;
  if (s.is_alive(v)) visit_ring(s, v, [&](int) { ++size; });
  const std::span<int> ring = room_for(s, star, size);
  star.size = static_cast<std::uint32_t>(size) & 0x7fffffffU;
  star.open = size > 0 && s.is_boundary(v) ? 1U : 0U;
  if (size == 0) return;
  auto next = ring.begin();
  visit_ring(s, v, [&](int w) { *next++ = w; });
  if (star.open == 0)
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

void refresh_stars(Surface& s) {
  for (int v = 0; v < s.vertex_slots(); ++v) refresh_star(s, v);
}

bool stars_are_right(const Surface& s) {
  Surface anew = s;
  refresh_stars(anew);
  for (int v = 0; v < s.vertex_slots(); ++v) {
    const VertexStar &a = s.star(v), &b = anew.star(v);
    if (a.size != b.size || a.open != b.open) return false;
    if (!std::equal(s.ring(a), s.ring(a) + a.size, anew.ring(b))) return false;
  }
  return true;
}

}  // namespace tdbd::mesh

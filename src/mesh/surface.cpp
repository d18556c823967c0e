#include "mesh/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "core/compensated_sum.hpp"
#include "core/error.hpp"

namespace tdbd::mesh {
namespace {

Side side_of(const std::vector<Triangle>& triangles, int corner) {
  const Triangle& c = triangles[at(corner / 3)];
  const int from = c[at((corner + 1) % 3)], to = c[at((corner + 2) % 3)];
  return {std::min(from, to), std::max(from, to), corner / 3, from < to, corner};
}

template <class Visit>
void visit_sides(const std::vector<Triangle>& triangles, Visit visit) {
  for (int corner = 0; corner < 3 * static_cast<int>(triangles.size()); ++corner)
    if (triangles[at(corner / 3)][0] >= 0) visit(side_of(triangles, corner));
}

/// Start index of the sides of each lower vertex, followed by the total number of sides.
std::vector<std::size_t> starts_by_lower_vertex(const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> starts;
  visit_sides(triangles, [&](const Side& s) {
    if (at(s.lo) + 2 > starts.size()) starts.resize(at(s.lo) + 2, 0);
    ++starts[at(s.lo) + 1];
  });
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  return starts;
}

}  // namespace

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  const std::vector<std::size_t> starts = starts_by_lower_vertex(triangles);
  if (starts.empty()) return {};
  std::vector<std::size_t> next = starts;
  std::vector<Side> sides(starts.back());
  visit_sides(triangles, [&](const Side& s) { sides[next[at(s.lo)]++] = s; });
  for (std::size_t v = 0; v + 1 < starts.size(); ++v)
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(starts[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(starts[v + 1]),
              [](const Side& a, const Side& b) {
                return std::tie(a.hi, a.corner) < std::tie(b.hi, b.corner);
              });
  return sides;
}

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
std::span<int> ring_storage(Surface& s, VertexStar& star, int size) {
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
  const std::span<int> ring = ring_storage(s, star, size);
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

bool stars_are_consistent(const Surface& s) {
  Surface anew = s;
  refresh_stars(anew);
  for (int v = 0; v < s.vertex_slots(); ++v) {
    const VertexStar &a = s.star(v), &b = anew.star(v);
    if (a.size != b.size || a.open != b.open) return false;
    if (!std::equal(s.ring(a), s.ring(a) + a.size, anew.ring(b))) return false;
  }
  return true;
}

namespace {

std::string place(const TriangleMesh& m, int v) {
  const Vec3 x = 1e3 * m.positions[at(v)];
  return fmt::format("vertex {} at ({:.3f}, {:.3f}, {:.3f}) mm", v, x.x(), x.y(), x.z());
}

void set_boundary(Surface& s, const Side& e) {
  s.boundary[at(e.lo)] = 1;
  s.boundary[at(e.hi)] = 1;
}

std::vector<int> first_corners(const Surface& s) {
  std::vector<int> corner(s.stars.size(), -1);
  for (int c = 3 * s.triangle_slots() - 1; c >= 0; --c)
    if (s.triangle_is_alive(c / 3)) corner[at(s.vertex(c))] = c;
  return corner;
}

}  // namespace

int corner_facing(const Surface& s, int a, int b) {
  int found = -1;
  visit_corners(s, a, [&](int c) {
    if (s.vertex(next_corner(c)) == b) found = previous_corner(c);
  });
  return found;
}

Surface make_surface(const TriangleMesh& m) {
  Surface s;
  s.stars.resize(m.positions.size());
  for (std::size_t v = 0; v < m.positions.size(); ++v) s.stars[v].x = m.positions[v];
  s.triangles = m.triangles;
  s.opposite.assign(3 * m.triangles.size(), -1);
  s.boundary.assign(m.positions.size(), 0);
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first > 2)
      throw InputError(fmt::format("edge between {} and {} has {} triangles, at most 2 expected",
                                   place(m, first->lo), place(m, first->hi), last - first));
    if (last - first == 1) return set_boundary(s, *first);
    if (first[0].forward == first[1].forward)
      throw InputError(fmt::format(
          "facets on both sides of the edge between {} and {} disagree about their orientation",
          place(m, first->lo), place(m, first->hi)));
    s.opposite[at(first[0].corner)] = first[1].corner;
    s.opposite[at(first[1].corner)] = first[0].corner;
  });
  s.corner_of = first_corners(s);
  refresh_stars(s);
  return s;
}

TriangleMesh compact(const Surface& s, std::vector<int>* slot_of_vertex) {
  TriangleMesh m;
  std::vector<int> renumbered(s.stars.size(), -1);
  if (slot_of_vertex) slot_of_vertex->clear();
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!s.is_alive(v)) continue;
    renumbered[at(v)] = static_cast<int>(m.positions.size());
    m.positions.push_back(s.position(v));
    if (slot_of_vertex) slot_of_vertex->push_back(v);
  }
  for (const Triangle& t : s.triangles)
    if (t[0] >= 0)
      m.triangles.push_back({renumbered[at(t[0])], renumbered[at(t[1])], renumbered[at(t[2])]});
  return m;
}

std::vector<Vec3> positions_of(const Surface& s) {
  std::vector<Vec3> positions;
  positions.reserve(s.stars.size());
  for (const VertexStar& star : s.stars) positions.push_back(star.x);
  return positions;
}

bool adjacency_is_consistent(const Surface& s) {
  std::vector<int> opposite(s.opposite.size(), -1);
  std::vector<std::uint8_t> boundary(s.boundary.size(), 0);
  bool is_manifold = true;
  for_each_edge(sorted_sides(s.triangles), [&](const Side* first, const Side* last) {
    if (last - first == 1) {
      boundary[at(first->lo)] = boundary[at(first->hi)] = 1;
      return;
    }
    is_manifold = is_manifold && last - first == 2 && first[0].forward != first[1].forward;
    opposite[at(first[0].corner)] = first[1].corner;
    opposite[at(first[1].corner)] = first[0].corner;
  });
  if (!is_manifold) return false;
  for (std::size_t c = 0; c < opposite.size(); ++c)
    if (s.triangle_is_alive(static_cast<int>(c) / 3) && opposite[c] != s.opposite[c]) return false;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!s.is_alive(v)) continue;
    const int c = s.corner_of[at(v)];
    if (!s.triangle_is_alive(c / 3) || s.vertex(c) != v) return false;
    if (boundary[at(v)] != s.boundary[at(v)]) return false;
  }
  return stars_are_consistent(s);
}

double hole_volume(const Surface& s, const Vec3& origin_W) {
  CompensatedSum six_volumes;
  for (const Triangle& t : s.triangles) {
    if (t[0] < 0) continue;
    const Vec3 a = s.position(t[0]) - origin_W, b = s.position(t[1]) - origin_W,
               c = s.position(t[2]) - origin_W;
    six_volumes.add(a.dot(b.cross(c)));
  }
  return -six_volumes.value() / 6.0;
}

}  // namespace tdbd::mesh

#include "mesh/surface.hpp"

#include <fmt/format.h>

#include "core/compensated_sum.hpp"
#include "core/error.hpp"
#include "mesh/sides.hpp"

namespace tdbd::mesh {
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
  return stars_are_right(s);
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

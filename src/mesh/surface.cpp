#include "mesh/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/compensated_sum.hpp"
#include "core/error.hpp"

namespace tdbd::mesh {
namespace {

/// A directed edge as its triangle sees it, with the corner that faces it.
struct Edge {
  int lo, hi;
  bool forward;
  int corner;
  auto key() const { return std::tie(lo, hi); }
};

std::vector<Edge> sorted_edges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const Triangle& tri = triangles[static_cast<std::size_t>(t)];
      if (tri[0] < 0) continue;
      const int a = tri[static_cast<std::size_t>((i + 1) % 3)];
      const int b = tri[static_cast<std::size_t>((i + 2) % 3)];
      edges.push_back({std::min(a, b), std::max(a, b), a < b, 3 * t + i});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::tie(x.lo, x.hi, x.corner) < std::tie(y.lo, y.hi, y.corner);
  });
  return edges;
}

std::string place(const TriangleMesh& m, int v) {
  const Vec3 x = 1e3 * m.positions[static_cast<std::size_t>(v)];
  return fmt::format("vertex {} at ({:.3f}, {:.3f}, {:.3f}) mm", v, x.x(), x.y(), x.z());
}

void set_boundary(Surface& s, const Edge& e) {
  s.boundary[static_cast<std::size_t>(e.lo)] = 1;
  s.boundary[static_cast<std::size_t>(e.hi)] = 1;
}

std::vector<int> first_corners(const Surface& s) {
  std::vector<int> corner(s.positions.size(), -1);
  for (int c = 3 * s.triangle_slots() - 1; c >= 0; --c)
    if (s.triangle_is_alive(c / 3)) corner[static_cast<std::size_t>(s.vertex(c))] = c;
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
  s.positions = m.positions;
  s.triangles = m.triangles;
  s.opposite.assign(3 * m.triangles.size(), -1);
  s.boundary.assign(m.positions.size(), 0);
  const std::vector<Edge> edges = sorted_edges(m.triangles);
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && edges[end].key() == edges[k].key()) ++end;
    if (end - k > 2)
      throw InputError(fmt::format("edge between {} and {} has {} triangles, at most 2 expected",
                                   place(m, edges[k].lo), place(m, edges[k].hi), end - k));
    if (end - k == 2 && edges[k].forward == edges[k + 1].forward)
      throw InputError(fmt::format(
          "facets on both sides of the edge between {} and {} disagree about their orientation",
          place(m, edges[k].lo), place(m, edges[k].hi)));
    if (end - k == 2) {
      s.opposite[static_cast<std::size_t>(edges[k].corner)] = edges[k + 1].corner;
      s.opposite[static_cast<std::size_t>(edges[k + 1].corner)] = edges[k].corner;
    } else {
      set_boundary(s, edges[k]);
    }
    k = end;
  }
  s.corner_of = first_corners(s);
  return s;
}

TriangleMesh compact(const Surface& s, std::vector<int>* slot_of_vertex) {
  TriangleMesh m;
  std::vector<int> renumbered(s.positions.size(), -1);
  if (slot_of_vertex) slot_of_vertex->clear();
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!s.is_alive(v)) continue;
    renumbered[static_cast<std::size_t>(v)] = static_cast<int>(m.positions.size());
    m.positions.push_back(s.position(v));
    if (slot_of_vertex) slot_of_vertex->push_back(v);
  }
  for (const Triangle& t : s.triangles)
    if (t[0] >= 0)
      m.triangles.push_back({renumbered[static_cast<std::size_t>(t[0])],
                             renumbered[static_cast<std::size_t>(t[1])],
                             renumbered[static_cast<std::size_t>(t[2])]});
  return m;
}

bool adjacency_is_consistent(const Surface& s) {
  std::vector<int> opposite(s.opposite.size(), -1);
  std::vector<std::uint8_t> boundary(s.boundary.size(), 0);
  const std::vector<Edge> edges = sorted_edges(s.triangles);
  for (std::size_t k = 0; k < edges.size();) {
    const bool paired = k + 1 < edges.size() && edges[k + 1].key() == edges[k].key();
    if (paired && edges[k].forward == edges[k + 1].forward) return false;
    if (paired) {
      opposite[static_cast<std::size_t>(edges[k].corner)] = edges[k + 1].corner;
      opposite[static_cast<std::size_t>(edges[k + 1].corner)] = edges[k].corner;
    } else {
      boundary[static_cast<std::size_t>(edges[k].lo)] = 1;
      boundary[static_cast<std::size_t>(edges[k].hi)] = 1;
    }
    k += paired ? 2 : 1;
  }
  for (std::size_t c = 0; c < opposite.size(); ++c)
    if (s.triangle_is_alive(static_cast<int>(c) / 3) && opposite[c] != s.opposite[c]) return false;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!s.is_alive(v)) continue;
    const int c = s.corner_of[static_cast<std::size_t>(v)];
    if (!s.triangle_is_alive(c / 3) || s.vertex(c) != v) return false;
    if (boundary[static_cast<std::size_t>(v)] != s.boundary[static_cast<std::size_t>(v)])
      return false;
  }
  return true;
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

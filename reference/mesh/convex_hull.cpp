#include "reference/mesh/convex_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "reference/mesh/cgal_surface.hpp"

namespace tdbd::reference {
namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Edge = std::pair<int, int>;

Point point(const Vec3& x) { return {x[0], x[1], x[2]}; }

bool is_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Sorts vertices by their coordinates.
void number_by_place(mesh::TriangleMesh& m) {
  std::vector<int> order(m.positions.size()), number(m.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return is_before(m.positions[a], m.positions[b]); });
  std::vector<Vec3> positions;
  for (const int v : order) {
    number[v] = static_cast<int>(positions.size());
    positions.push_back(m.positions[v]);
  }
  m.positions = std::move(positions);
  for (mesh::Triangle& t : m.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
}

std::map<Edge, int> triangles_by_edge(const mesh::TriangleMesh& m) {
  std::map<Edge, int> of_edge;
  for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) of_edge[{m.triangles[t][i], m.triangles[t][(i + 1) % 3]}] = t;
  return of_edge;
}

bool is_flat(const mesh::TriangleMesh& m, const Edge& e, int left, int right) {
  const auto opposite = [&](int t) {
    for (const int v : m.triangles[t])
      if (v != e.first && v != e.second) return point(m.positions[v]);
    throw RunError("convex_hull: a triangle has a corner twice");
  };
  return CGAL::coplanar(point(m.positions[e.first]), point(m.positions[e.second]), opposite(left),
                        opposite(right));
}

/// For each triangle, the first triangle in its plane.
std::vector<int> first_of_plane(const mesh::TriangleMesh& m, const std::map<Edge, int>& of_edge) {
  std::vector<int> first(m.triangles.size());
  std::iota(first.begin(), first.end(), 0);
  for (const auto& [e, t] : of_edge) {
    const int across = of_edge.at({e.second, e.first});
    if (first[t] == first[across] || !is_flat(m, e, t, across)) continue;
    const int from = std::max(first[t], first[across]), to = std::min(first[t], first[across]);
    std::replace(first.begin(), first.end(), from, to);
  }
  return first;
}

/// Triangulates each planar face as a fan around its first vertex, because CGAL divides faces in an
/// order that depends on addresses.
void divide_faces(mesh::TriangleMesh& m) {
  const std::map<Edge, int> of_edge = triangles_by_edge(m);
  const std::vector<int> first = first_of_plane(m, of_edge);
  std::map<int, std::map<int, int>> rims;  // by face: from each vertex to the next
  for (const auto& [e, t] : of_edge)
    if (first[t] != first[of_edge.at({e.second, e.first})]) rims[first[t]][e.first] = e.second;
  m.triangles.clear();
  for (const auto& [face, next] : rims) {
    const int start = next.begin()->first;
    for (int v = next.at(start), w = next.at(v); w != start; v = w, w = next.at(w))
      m.triangles.push_back({start, v, w});
  }
  std::sort(m.triangles.begin(), m.triangles.end());
}

}  // namespace

mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  std::vector<Point> input;
  for (const Vec3& x : points) input.push_back(point(x));
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  mesh::TriangleMesh m = triangle_mesh_of(hull, [](double x) { return x; });
  number_by_place(m);
  divide_faces(m);
  return m;
}

}  // namespace tdbd::reference

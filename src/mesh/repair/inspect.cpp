#include "mesh/repair/inspect.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/check/topology.hpp"

namespace tdbd::mesh {
namespace {

std::size_t equal_points(const TriangleMesh& m) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& x : m.positions) places.insert({x.x(), x.y(), x.z()});
  return m.positions.size() - places.size();
}

std::size_t duplicates(const TriangleMesh& m) {
  std::set<Triangle> corners;
  for (Triangle t : m.triangles) {
    std::sort(t.begin(), t.end());
    corners.insert(t);
  }
  return m.triangles.size() - corners.size();
}

void measure_edges(const TriangleMesh& m, const std::vector<Side>& sides, Inspection& found) {
  std::size_t edges = 0;
  found.shortest_edge = std::numeric_limits<double>::infinity();
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    const double length = (position(m, first->hi) - position(m, first->lo)).norm();
    found.shortest_edge = std::min(found.shortest_edge, length);
    found.longest_edge = std::max(found.longest_edge, length);
    found.mean_edge += length;
    ++edges;
    found.open_edges += last - first == 1;
    found.non_manifold_edges += last - first > 2;
    found.flipped_edges += last - first == 2 && first[0].forward == first[1].forward;
  });
  found.mean_edge /= static_cast<double>(std::max<std::size_t>(edges, 1));
}

}  // namespace

Inspection inspect(const TriangleMesh& m) {
  Inspection found;
  found.vertices = m.positions.size();
  found.facets = m.triangles.size();
  found.equal_points = equal_points(m);
  found.duplicates = duplicates(m);
  const std::vector<Side> sides = sorted_sides(m);
  measure_edges(m, sides, found);
  found.pieces = connected_pieces(m.triangles).size();
  const std::vector<int> fans = fan_counts(m, sides);
  found.non_manifold_vertices = static_cast<std::size_t>(
      std::count_if(fans.begin(), fans.end(), [](int n) { return n > 1; }));
  found.worst_quality = 1.0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    const double q = triangle_quality(a, b, c);
    found.worst_quality = std::min(found.worst_quality, q);
    found.degenerate += q < degenerate_quality;
  }
  found.intersecting_pairs = self_intersections(m).size();
  found.volume = enclosed_volume(m);
  found.area = area(m);
  found.box = bounding_box(m);
  return found;
}

}  // namespace tdbd::mesh

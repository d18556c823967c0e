#include "mesh/shape/clip_convex.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

constexpr double on_plane = 1e-12;  ///< relative to the size of the mesh

/// A mesh being clipped: the signed heights of its vertices above the plane, and the new vertices,
/// one per edge that crosses the plane.
struct Cut {
  TriangleMesh mesh;
  std::vector<double> height;
  std::map<std::pair<int, int>, int> crossing;
};

Cut start_cut(const TriangleMesh& m, const Vec3& n, double b) {
  Cut cut{{m.positions, {}}, {}, {}};
  const double slack = on_plane * bounding_box(m).size().norm();
  for (const Vec3& x : m.positions) {
    const double height = n.dot(x) - b;
    cut.height.push_back(std::abs(height) <= slack ? 0.0 : height);
  }
  return cut;
}

int crossing_vertex(Cut& cut, int i, int j) {
  const auto [lo, hi] = std::minmax(i, j);
  const auto [place, is_new] =
      cut.crossing.emplace(std::pair(lo, hi), static_cast<int>(cut.mesh.positions.size()));
  if (is_new) {
    const double w = cut.height[lo] / (cut.height[lo] - cut.height[hi]);
    const Vec3 &a = cut.mesh.positions[lo], &b = cut.mesh.positions[hi];
    cut.mesh.positions.push_back(a + w * (b - a));
    cut.height.push_back(0.0);
  }
  return place->second;
}

/// The part of a triangle below the plane: a polygon of up to four corners.
std::vector<int> inner_polygon(Cut& cut, const Triangle& t) {
  std::vector<int> polygon;
  for (int k = 0; k < 3; ++k) {
    const int i = t[k], j = t[(k + 1) % 3];
    if (cut.height[i] <= 0.0) polygon.push_back(i);
    if (cut.height[i] * cut.height[j] < 0.0) polygon.push_back(crossing_vertex(cut, i, j));
  }
  return polygon;
}

bool inside_somewhere(const Cut& cut, const std::vector<int>& polygon) {
  return std::ranges::any_of(polygon, [&](int i) { return cut.height[i] < 0.0; });
}

/// Closes the mesh by a fan about the mean of its open edges, all of which lie in the plane.
void close(TriangleMesh& m) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  std::vector<std::pair<int, int>> open;
  for (const auto& [i, j] : edges)
    if (!edges.contains({j, i})) open.emplace_back(i, j);
  if (open.empty()) return;
  Vec3 middle = Vec3::Zero();
  for (const auto& edge : open) middle += m.positions[edge.first];
  const int centre = static_cast<int>(m.positions.size());
  m.positions.emplace_back(middle / static_cast<double>(open.size()));
  for (const auto& [i, j] : open) m.triangles.push_back({j, i, centre});
}

TriangleMesh without_unused(const TriangleMesh& m) {
  TriangleMesh compact;
  std::vector<int> place(m.positions.size(), -1);
  for (Triangle t : m.triangles) {
    for (int& i : t) {
      if (place[i] < 0) {
        place[i] = static_cast<int>(compact.positions.size());
        compact.positions.push_back(m.positions[i]);
      }
      i = place[i];
    }
    compact.triangles.push_back(t);
  }
  return compact;
}

}  // namespace

TriangleMesh clipped_convex(const TriangleMesh& m, const Vec3& n, double b) {
  Cut cut = start_cut(m, n, b);
  if (std::ranges::none_of(cut.height, [](double h) { return h > 0.0; })) return m;
  for (const Triangle& t : m.triangles) {
    const std::vector<int> polygon = inner_polygon(cut, t);
    if (!inside_somewhere(cut, polygon)) continue;
    for (std::size_t k = 2; k < polygon.size(); ++k)
      cut.mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }
  close(cut.mesh);
  return without_unused(cut.mesh);
}

}  // namespace tdbd::mesh

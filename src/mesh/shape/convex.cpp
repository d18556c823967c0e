#include "mesh/shape/convex.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/simd.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

struct Plane {
  Vec3 n;
  double b;
};

Vec3 corner(const TriangleMesh& m, const Triangle& t, int i) { return m.positions[at(t[at(i)])]; }

Vec3 area_vector_of(const TriangleMesh& m, const Triangle& t) {
  return area_vector(corner(m, t, 0), corner(m, t, 1), corner(m, t, 2));
}

bool lies_on(const TriangleMesh& m, const Triangle& t, const Vec3& area, const Plane& p,
             double slack) {
  if (area.dot(p.n) < 0.9 * area.norm()) return false;
  for (int i = 0; i < 3; ++i)
    if (std::abs(p.n.dot(corner(m, t, i)) - p.b) > slack) return false;
  return true;
}

/// Triangle indices, largest area first: rounded coordinates change their normals least.
std::vector<int> by_decreasing_area(const TriangleMesh& m) {
  std::vector<double> area(m.triangles.size());
  for (std::size_t t = 0; t < area.size(); ++t) area[t] = area_vector_of(m, m.triangles[t]).norm();
  std::vector<int> order(m.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int i, int j) { return area[at(i)] > area[at(j)]; });
  return order;
}

/// Returns at most `most` + 1 planes.
std::vector<Plane> distinct_planes(const TriangleMesh& m, double slack, std::size_t most) {
  std::vector<Plane> planes;
  for (const int k : by_decreasing_area(m)) {
    const Triangle& t = m.triangles[at(k)];
    const Vec3 area = area_vector_of(m, t);
    if (area.norm() == 0.0) continue;
    const bool known = std::any_of(planes.begin(), planes.end(),
                                   [&](const Plane& p) { return lies_on(m, t, area, p, slack); });
    if (!known) planes.push_back({area.normalized(), area.normalized().dot(corner(m, t, 0))});
    if (planes.size() > most) break;
  }
  return planes;
}

}  // namespace

void add_plane(ConvexSolid& s, const Vec3& n, double b) {
  s.nx.push_back(n.x());
  s.ny.push_back(n.y());
  s.nz.push_back(n.z());
  s.b.push_back(b);
  s.planes = s.b.size();
}

void pad(ConvexSolid& s) {
  const std::size_t n = (s.planes + lanes - 1) / lanes * lanes;
  for (auto* column : {&s.nx, &s.ny, &s.nz}) column->resize(n, 0.0);
  s.b.resize(n, std::numeric_limits<double>::infinity());
}

std::optional<ConvexSolid> convex_solid(const TriangleMesh& m, std::size_t most) {
  const double slack = tolerance::convex * bounding_box(m).size().norm();
  ConvexSolid solid;
  const std::vector<Plane> planes = distinct_planes(m, slack, most);
  if (planes.size() > most) return std::nullopt;
  for (const Plane& p : planes) {
    double support = p.b;
    for (const Vec3& x : m.positions) support = std::max(support, p.n.dot(x));
    if (support - p.b > slack) return std::nullopt;
    add_plane(solid, p.n, support);
  }
  pad(solid);
  return solid;
}

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

bool has_interior_corner(const Cut& cut, const std::vector<int>& polygon) {
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
    if (!has_interior_corner(cut, polygon)) continue;
    for (std::size_t k = 2; k < polygon.size(); ++k)
      cut.mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }
  close(cut.mesh);
  return without_unused(cut.mesh);
}

}  // namespace tdbd::mesh

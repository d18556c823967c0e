#include "mesh/shape/convex.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

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

/// A vertex of an edge that crosses the plane, found from the end of the edge below the plane.
struct Crossing {
  int above;     ///< the end of the edge above the plane
  int vertex;    ///< the new vertex
  int previous;  ///< index of another crossing of the same lower end, or -1
};

/// A mesh being clipped.
struct Cut {
  TriangleMesh mesh;
  std::vector<double> height;       ///< of the vertices above the plane
  std::vector<Crossing> crossings;  ///< one per edge that crosses the plane
  std::vector<int> last;            ///< of each given vertex: its last crossing, or -1
};

Cut start_cut(const TriangleMesh& m, const Vec3& n, double b) {
  Cut cut;
  cut.height.reserve(m.positions.size());
  const double slack = on_plane * bounding_box(m).size().norm();
  for (const Vec3& x : m.positions) {
    const double height = n.dot(x) - b;
    cut.height.push_back(std::abs(height) <= slack ? 0.0 : height);
  }
  return cut;
}

int crossing_vertex(Cut& cut, int i, int j) {
  const int below = cut.height[at(i)] < 0.0 ? i : j, above = below == i ? j : i;
  for (int k = cut.last[at(below)]; k >= 0; k = cut.crossings[at(k)].previous)
    if (cut.crossings[at(k)].above == above) return cut.crossings[at(k)].vertex;
  const int vertex = static_cast<int>(cut.mesh.positions.size());
  cut.crossings.push_back({above, vertex, cut.last[at(below)]});
  cut.last[at(below)] = static_cast<int>(cut.crossings.size()) - 1;
  const int lo = std::min(i, j), hi = std::max(i, j);
  const double w = cut.height[at(lo)] / (cut.height[at(lo)] - cut.height[at(hi)]);
  const Vec3 a = cut.mesh.positions[at(lo)], b = cut.mesh.positions[at(hi)];
  cut.mesh.positions.emplace_back(a + w * (b - a));
  cut.height.push_back(0.0);
  return vertex;
}

/// Adds the part of a triangle below the plane, a polygon of up to four corners, as a fan.
void add_inner(Cut& cut, const Triangle& t) {
  std::array<int, 4> polygon;
  std::size_t corners = 0;
  bool is_inside = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = t[k], j = t[(k + 1) % 3];
    const double here = cut.height[at(i)], there = cut.height[at(j)];
    is_inside = is_inside || here < 0.0;
    if (here <= 0.0) polygon[corners++] = i;
    if (here * there < 0.0) polygon[corners++] = crossing_vertex(cut, i, j);
  }
  if (!is_inside) return;
  for (std::size_t k = 2; k < corners; ++k)
    cut.mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
}

/// Closes the mesh by a fan about the mean of its open edges, all of which lie in the plane.
void close(Cut& cut) {
  TriangleMesh& m = cut.mesh;
  std::vector<std::pair<int, int>> edges;
  for (const Triangle& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3];
      if (cut.height[at(i)] == 0.0 && cut.height[at(j)] == 0.0) edges.emplace_back(i, j);
    }
  std::ranges::sort(edges);
  std::vector<std::pair<int, int>> open;
  for (const auto& [i, j] : edges)
    if (!std::ranges::binary_search(edges, std::pair(j, i))) open.emplace_back(i, j);
  if (open.empty()) return;
  Vec3 middle = Vec3::Zero();
  for (const auto& edge : open) middle += m.positions[at(edge.first)];
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
  if (std::ranges::none_of(cut.height, [](double h) { return h < 0.0; })) return {};
  cut.mesh.positions = m.positions;
  cut.last.assign(m.positions.size(), -1);
  for (const Triangle& t : m.triangles) add_inner(cut, t);
  close(cut);
  return without_unused(cut.mesh);
}

}  // namespace tdbd::mesh

#include "mesh/shape/convex.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/tolerance.hpp"
#include "core/wide.hpp"
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
std::vector<int> by_falling_area(const TriangleMesh& m) {
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
  for (const int k : by_falling_area(m)) {
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

}  // namespace tdbd::mesh

#include "verification/battery/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace tdbd::battery {
namespace {

using mesh::TriangleMesh;

/// Quadrilateral a, b, c, d, counter-clockwise from outside.
void add_quad(TriangleMesh& m, int a, int b, int c, int d) {
  m.triangles.push_back({a, b, c});
  m.triangles.push_back({a, c, d});
}

TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Every triangle cut in four at the middles of its edges.
TriangleMesh quartered(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.positions, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const std::pair<int, int> edge(std::min(a, b), std::max(a, b));
    const auto [it, is_new] = middles.try_emplace(edge, static_cast<int>(fine.positions.size()));
    if (is_new) fine.positions.push_back(0.5 * (coarse.positions[a] + coarse.positions[b]));
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

TriangleMesh box(const Vec3& lo, const Vec3& hi) {
  TriangleMesh m;
  for (int i = 0; i < 8; ++i)
    m.positions.push_back({i & 1 ? hi[0] : lo[0], i & 2 ? hi[1] : lo[1], i & 4 ? hi[2] : lo[2]});
  add_quad(m, 0, 2, 3, 1);  // -z
  add_quad(m, 4, 5, 7, 6);  // +z
  add_quad(m, 0, 1, 5, 4);  // -y
  add_quad(m, 2, 6, 7, 3);  // +y
  add_quad(m, 0, 4, 6, 2);  // -x
  add_quad(m, 1, 3, 7, 5);  // +x
  return m;
}

TriangleMesh cylinder(double radius, double length, int sides) {
  TriangleMesh m;
  for (const double z : {-0.5 * length, 0.5 * length})
    for (int i = 0; i < sides; ++i) {
      const double phi = 2.0 * std::numbers::pi * i / sides;
      m.positions.push_back({radius * std::cos(phi), radius * std::sin(phi), z});
    }
  const int bottom = 2 * sides, top = bottom + 1;
  m.positions.push_back({0, 0, -0.5 * length});
  m.positions.push_back({0, 0, 0.5 * length});
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    add_quad(m, i, j, sides + j, sides + i);
    m.triangles.push_back({bottom, j, i});
    m.triangles.push_back({top, sides + i, sides + j});
  }
  return m;
}

TriangleMesh torus(double major_radius, double minor_radius, int around, int across) {
  TriangleMesh m;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double r = major_radius + minor_radius * std::cos(v);
      m.positions.push_back({r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v)});
      const int i1 = (i + 1) % around, j1 = (j + 1) % across;
      add_quad(m, i * across + j, i1 * across + j, i1 * across + j1, i * across + j1);
    }
  return m;
}

TriangleMesh sphere(double radius, int levels) {
  TriangleMesh m = icosahedron();
  for (int level = 0; level < levels; ++level) m = quartered(m);
  for (Vec3& x : m.positions) x *= radius / x.norm();
  return m;
}

TriangleMesh flat_rock(double half, double z, int n) {
  TriangleMesh m;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      m.positions.push_back({half * (2.0 * i / n - 1.0), half * (2.0 * j / n - 1.0), z});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      add_quad(m, a, a + n + 1, a + n + 2, a + 1);
    }
  return m;
}

TriangleMesh placed(const Pose& X, TriangleMesh m) {
  for (Vec3& x : m.positions) x = X * x;
  return m;
}

}  // namespace tdbd::battery

#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// The unit tetrahedron at the origin, normals outwards. m.
inline TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// A tetrahedron and its mirror image, with `shared` (1 or 2) vertices in common.
inline TriangleMesh two_tetrahedra_sharing(int shared) {
  TriangleMesh m = tetrahedron();
  const auto image = [&](int v) { return v < shared ? v : 4 + v - shared; };
  for (std::size_t v = static_cast<std::size_t>(shared); v < 4; ++v) {
    const Vec3 x = m.positions[v];
    m.positions.push_back(shared == 1 ? Vec3(-x) : Vec3(x.x(), -x.y(), -x.z()));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle t = m.triangles[i];
    m.triangles.push_back(shared == 1 ? Triangle{image(t[0]), image(t[2]), image(t[1])}
                                      : Triangle{image(t[0]), image(t[1]), image(t[2])});
  }
  return m;
}

/// The unit square in n x n cells of two triangles each, normals along +z. m.
inline TriangleMesh square_sheet(int n) {
  TriangleMesh m;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      m.positions.push_back(Vec3(static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      m.triangles.push_back({a, b, d});
      m.triangles.push_back({a, d, c});
    }
  return m;
}

/// Two sheets one above the other.
inline TriangleMesh two_sheets() {
  TriangleMesh m = square_sheet(2);
  const int n = static_cast<int>(m.positions.size());
  const TriangleMesh first = m;
  for (const Vec3& x : first.positions) m.positions.push_back(x + Vec3(0, 0, 1));
  for (const Triangle& t : first.triangles) m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return m;
}

}  // namespace tdbd::mesh

#include "verification/battery/rock_surfaces.hpp"

#include "core/random.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::battery {
namespace {

/// Turns the diagonal of every other quadrilateral, by chance.
void turn_diagonals(mesh::TriangleMesh& m, Random& random) {
  for (std::size_t t = 0; t + 1 < m.triangles.size(); t += 2) {
    const auto [a, b, c] = m.triangles[t];
    const int d = m.triangles[t + 1][2];
    if (random.next() % 2 == 0) continue;
    m.triangles[t] = {b, c, d};
    m.triangles[t + 1] = {b, d, a};
  }
}

}  // namespace

mesh::TriangleMesh bumpy_rock(double half, int n, double bump, std::uint64_t seed) {
  Random random{seed};
  mesh::TriangleMesh m = flat_rock(half, 0.0, n);
  turn_diagonals(m, random);
  const double reach = bump * 2.0 * half / n;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i)
      for (double& x : m.positions[j * (n + 1) + i]) x += random.uniform(-reach, reach);
  return m;
}

}  // namespace tdbd::battery

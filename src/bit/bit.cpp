#include "bit/bit.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::bit {

mesh::TriangleMesh mesh_B(const Part& part) {
  mesh::TriangleMesh m = part.mesh_P;
  for (Vec3& x : m.positions) x = part.X_BP * x;
  return m;
}

double largest_radius(const std::vector<Part>& parts) {
  double radius = 0.0;
  for (const Part& part : parts) {
    if (part.cutting != Cutting::cuts) continue;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_B = part.X_BP * x_P;
      radius = std::max(radius, std::hypot(x_B.x(), x_B.y()));
    }
  }
  return radius;
}

}  // namespace tdbd::bit

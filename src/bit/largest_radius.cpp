#include "bit/largest_radius.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::bit {

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

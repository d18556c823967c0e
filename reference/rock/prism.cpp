#include "reference/rock/prism.hpp"

#include <cmath>

namespace tdbd::reference {

double prism_volume(const Corners& from, const Corners& to) {
  const Vec3 d0 = to[0] - from[0], d1 = to[1] - from[1], d2 = to[2] - from[2];
  const Vec3 mean_d = (d0 + d1 + d2) / 3.0;
  const Vec3 e1 = from[1] - from[0], e2 = from[2] - from[0];
  const Vec3 de1 = d1 - d0, de2 = d2 - d0;
  double sum = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    const double zeta = 0.5 * (1.0 + sign / std::sqrt(3.0));
    sum += (e1 + zeta * de1).cross(e2 + zeta * de2).dot(mean_d);
  }
  return -0.25 * sum;  // 1/2 (triangle) times 1/2 (Gauss weight)
}

}  // namespace tdbd::reference

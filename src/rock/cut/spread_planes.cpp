#include "rock/cut/spread_planes.hpp"

#include <algorithm>
#include <vector>

namespace tdbd::rock {

mesh::ConvexSolid spread_planes(const mesh::ConvexSolid& planes, std::size_t most) {
  constexpr std::size_t first = 6;  // the sides of a box, if the solid has one
  mesh::ConvexSolid chosen;
  std::vector<double> nearest(planes.planes, -1.0);  // cosine to the nearest selected plane
  for (std::size_t k = 0; k < std::min(most, planes.planes); ++k) {
    const std::size_t next =
        k < first ? k
                  : static_cast<std::size_t>(std::ranges::min_element(nearest) - nearest.begin());
    const Vec3 n = mesh::normal(planes, next);
    mesh::add_plane(chosen, n, planes.b[next]);
    for (std::size_t i = 0; i < planes.planes; ++i)
      nearest[i] = std::max(nearest[i], n.dot(mesh::normal(planes, i)));
  }
  mesh::pad(chosen);
  return chosen;
}

}  // namespace tdbd::rock

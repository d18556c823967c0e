#include "mesh/sides.hpp"

#include <algorithm>
#include <tuple>

namespace tdbd::mesh {

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const Triangle& c = triangles[at(t)];
      if (c[0] < 0) continue;
      const int from = c[at((i + 1) % 3)], to = c[at((i + 2) % 3)];
      sides.push_back({std::min(from, to), std::max(from, to), t, from < to, 3 * t + i});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.lo, a.hi, a.corner) < std::tie(b.lo, b.hi, b.corner);
  });
  return sides;
}

}  // namespace tdbd::mesh

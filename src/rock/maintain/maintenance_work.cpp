#include "rock/maintain/maintenance_work.hpp"

#include <tuple>

#include "core/sort_unique.hpp"

namespace tdbd::rock {

EdgeCandidate edge_facing(const mesh::Surface& s, int c, double key) {
  const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
  return {key, std::min(a, b), std::max(a, b)};
}

void sort_edges(std::vector<EdgeCandidate>& edges) {
  sort_unique(
      edges,
      [](const EdgeCandidate& x, const EdgeCandidate& y) {
        return std::tie(x.key, x.a, x.b) < std::tie(y.key, y.a, y.b);
      },
      [](const EdgeCandidate& x, const EdgeCandidate& y) { return x.a == y.a && x.b == y.b; });
}

}  // namespace tdbd::rock

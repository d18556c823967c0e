#include "mesh/check_edges.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tdbd::mesh {

std::vector<Side> sorted_sides(const TriangleMesh& m) {
  std::vector<Side> sides;
  sides.reserve(3 * m.triangles.size());
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = m.triangles[t][k], to = m.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.lo, a.hi, a.triangle) < std::tie(b.lo, b.hi, b.triangle);
  });
  return sides;
}

DisjointSets::DisjointSets(std::size_t n) : parent_(n) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int i) {
  const auto parent = [this](int k) -> int& { return parent_[static_cast<std::size_t>(k)]; };
  while (parent(i) != i) i = parent(i) = parent(parent(i));
  return i;
}

void DisjointSets::join(int i, int j) {
  const auto [lo, hi] = std::minmax({find(i), find(j)});
  parent_[static_cast<std::size_t>(hi)] = lo;
}

}  // namespace tdbd::mesh

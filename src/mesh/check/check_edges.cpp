#include "mesh/check/check_edges.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tdbd::mesh {
namespace {

/// Number of the corner of triangle `t` at vertex `v`.
int corner(const TriangleMesh& m, int t, int v) {
  const Triangle& tri = m.triangles[at(t)];
  return 3 * t + (tri[0] == v ? 0 : tri[1] == v ? 1 : 2);
}

/// Corners of one vertex whose triangles share an edge at it belong to one fan.
DisjointSets fans_of_corners(const TriangleMesh& m, const std::vector<Side>& sides) {
  DisjointSets fans(3 * m.triangles.size());
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    for (const Side* s = first + 1; s < last; ++s)
      for (const int v : {s->lo, s->hi})
        fans.join(corner(m, first->triangle, v), corner(m, s->triangle, v));
  });
  return fans;
}

/// Number of sets, counting those alone whose members `use` picks.
template <class Use>
int count_sets(DisjointSets& sets, int n, Use use) {
  int count = 0;
  for (int i = 0; i < n; ++i) count += use(i) && sets.find(i) == i;
  return count;
}

}  // namespace

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
  const auto parent = [this](int k) -> int& { return parent_[at(k)]; };
  while (parent(i) != i) i = parent(i) = parent(parent(i));
  return i;
}

void DisjointSets::join(int i, int j) {
  const auto [lo, hi] = std::minmax({find(i), find(j)});
  parent_[at(hi)] = lo;
}

std::vector<int> fan_counts(const TriangleMesh& m, const std::vector<Side>& sides) {
  DisjointSets fans = fans_of_corners(m, sides);
  std::vector<int> count(m.positions.size(), 0);
  for (int c = 0; c < static_cast<int>(3 * m.triangles.size()); ++c)
    if (fans.find(c) == c) ++count[at(m.triangles[at(c / 3)][at(c % 3)])];
  return count;
}

Topology topology(const TriangleMesh& m, const std::vector<Side>& sides) {
  const int n = static_cast<int>(m.positions.size());
  DisjointSets pieces(m.positions.size()), loops(m.positions.size());
  std::vector<char> on_boundary(m.positions.size(), 0);
  int edges = 0;
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    ++edges;
    pieces.join(first->lo, first->hi);
    if (last - first > 1) return;
    loops.join(first->lo, first->hi);
    on_boundary[at(first->lo)] = on_boundary[at(first->hi)] = 1;
  });
  return {count_sets(pieces, n, [](int) { return true; }),
          count_sets(loops, n, [&](int v) { return on_boundary[at(v)] != 0; }),
          n - edges + static_cast<int>(m.triangles.size())};
}

}  // namespace tdbd::mesh

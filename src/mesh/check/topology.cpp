#include "mesh/check/topology.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tdbd::mesh {
namespace {

/// Joins corners of a vertex into one fan if their triangles share an edge at that vertex.
DisjointSets fans_of_corners(const TriangleMesh& m, const std::vector<Side>& sides) {
  DisjointSets fans(3 * m.triangles.size());
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    for (const Side* s = first + 1; s < last; ++s)
      for (const int v : {s->lo, s->hi})
        fans.join(corner_at(m.triangles, first->triangle, v),
                  corner_at(m.triangles, s->triangle, v));
  });
  return fans;
}

/// Counts the sets whose representative satisfies `use`.
template <class Use>
int count_sets(DisjointSets& sets, int n, Use use) {
  int count = 0;
  for (int i = 0; i < n; ++i) count += use(i) && sets.find(i) == i;
  return count;
}

}  // namespace

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

std::vector<std::vector<int>> connected_pieces(const std::vector<Triangle>& triangles) {
  DisjointSets sets(triangles.size());
  for_each_edge(sorted_sides(triangles), [&](const Side* first, const Side* last) {
    for (const Side* s = first; s < last; ++s) sets.join(first->triangle, s->triangle);
  });
  std::map<int, std::vector<int>> of_set;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) of_set[sets.find(t)].push_back(t);
  std::vector<std::vector<int>> pieces;
  pieces.reserve(of_set.size());
  for (auto& [first, piece] : of_set) pieces.push_back(std::move(piece));
  return pieces;
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

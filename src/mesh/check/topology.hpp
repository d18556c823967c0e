#pragma once

#include <cstddef>
#include <vector>

#include "mesh/sides.hpp"

namespace tdbd::mesh {

/// Disjoint sets of 0 .. n-1 with path halving. The smallest member represents its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n);
  int find(int i);
  void join(int i, int j);

 private:
  std::vector<int> parent_;
};

/// Groups triangles that are connected by shared edges. Each piece is in ascending order; the
/// pieces are ordered by their first triangles.
std::vector<std::vector<int>> connected_pieces(const std::vector<Triangle>& triangles);

/// Number of fans of triangles around each vertex: 1 for a manifold, 0 for an isolated vertex.
std::vector<int> fan_counts(const TriangleMesh& m, const std::vector<Side>& sides);

/// Topological invariants of a surface. `loops` requires manifold vertices.
struct Topology {
  int pieces = 0;  ///< connected parts; an isolated vertex counts as one
  int loops = 0;   ///< closed chains of open edges
  int euler = 0;   ///< V - E + F
};
Topology topology(const TriangleMesh& m, const std::vector<Side>& sides);

}  // namespace tdbd::mesh

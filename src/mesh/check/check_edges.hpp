#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// One side of a triangle, under the edge lo < hi that it lies on.
struct Side {
  int lo = 0;
  int hi = 0;
  int triangle = 0;
  bool forward = false;  ///< the triangle runs from lo to hi
};

/// All sides, sorted so that the sides of one edge stand together, in the order of the triangles.
std::vector<Side> sorted_sides(const TriangleMesh& m);

/// Calls visit(first, last) for the run of sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi) ++j;
    visit(&sides[i], sides.data() + j);
  }
}

/// Disjoint sets of 0 .. n-1 with path halving; the smallest member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n);
  int find(int i);
  void join(int i, int j);

 private:
  std::vector<int> parent_;
};

/// Number of fans of triangles around each vertex: 1 for a manifold, 0 for an isolated vertex.
std::vector<int> fan_counts(const TriangleMesh& m, const std::vector<Side>& sides);

/// Numbers that tell surfaces apart. The loops are those of a mesh with manifold vertices.
struct Topology {
  int pieces = 0;  ///< connected parts; an isolated vertex is one
  int loops = 0;   ///< closed chains of open edges
  int euler = 0;   ///< V - E + F
};
Topology topology(const TriangleMesh& m, const std::vector<Side>& sides);

}  // namespace tdbd::mesh

#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// One side of a triangle; lo < hi are the ends of its edge.
struct Side {
  int lo = 0;
  int hi = 0;
  int triangle = 0;
  bool forward = false;  ///< whether the triangle traverses the edge from lo to hi
  int corner = 0;        ///< 3 triangle + i, the corner that faces this side
};

/// Returns all sides, sorted so that the sides of one edge are adjacent, in the order of their
/// triangles. Dead triangles (first corner negative) have no sides.
std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles);
inline std::vector<Side> sorted_sides(const TriangleMesh& m) { return sorted_sides(m.triangles); }

/// Calls visit(first, last) with the range of sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi) ++j;
    visit(&sides[i], sides.data() + j);
  }
}

/// The corner 3 t + i of triangle t at vertex v.
inline int corner_at(const std::vector<Triangle>& triangles, int t, int v) {
  const Triangle& c = triangles[at(t)];
  return 3 * t + (c[0] == v ? 0 : c[1] == v ? 1 : 2);
}

}  // namespace tdbd::mesh

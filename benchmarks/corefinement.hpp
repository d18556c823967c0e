#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::bench {

/// Result and run time of one boolean.
struct BooleanCut {
  double cpu_seconds = 0.0;  ///< of the boolean alone, without making meshes and hulls
  double removed = 0.0;      ///< m3
  mesh::TriangleMesh block_W;
};

/// Computes the closed rock minus the convex hulls of these points, with all hulls as one tool, by
/// CGAL's corefinement with exact predicates and rounded constructions. The hulls must not
/// intersect. Throws RunError if they do, or if CGAL fails.
BooleanCut cut_by_corefinement(const mesh::TriangleMesh& block_W,
                               const std::vector<std::vector<Vec3>>& hulls_W);

}  // namespace tdbd::bench

#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::bench {

/// What one boolean took, and left.
struct BooleanCut {
  double cpu_seconds = 0.0;  ///< of the boolean alone; making meshes and hulls is not counted
  double removed = 0.0;      ///< m3
  mesh::TriangleMesh block_W;
};

/// The closed rock minus the convex hulls of these points, all hulls as one tool, by CGAL's
/// corefinement with exact predicates and rounded constructions. The hulls may not meet. Throws
/// RunError if they do or CGAL gives up.
BooleanCut cut_by_corefinement(const mesh::TriangleMesh& block_W,
                               const std::vector<std::vector<Vec3>>& hulls_W);

}  // namespace tdbd::bench

#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Volumes of the rock, m3.
struct SweptBoolean {
  double before = 0.0;
  double after = 0.0;
  double removed = 0.0;       ///< before - after, exact before rounding
  mesh::TriangleMesh left_W;  ///< the remaining rock, its corners rounded
};

/// Twin of the removed volume (rock (10) and rock (11); thesis: 4.3) that does not move vertices:
/// the block of rock (closed, spatial frame) minus the convex hulls of the part at every two
/// consecutive poses, by CGAL's exact booleans. For a convex part (for a nonconvex one, its hull)
/// the swept volume is exact under translation. Under rotation the poses are connected by chords,
/// so many poses are needed. Nothing is projected onto rock vertices: the difference from the
/// program's volume is the resolution of its rock mesh. Throws RunError if a difference is not a
/// manifold. The run time is proportional to poses x (rock triangles + part triangles) in exact
/// arithmetic. Under rotation the size of the exact numbers grows with every pose: milliseconds for
/// three poses of a box, a minute for nine.
SweptBoolean swept_boolean(const mesh::TriangleMesh& block_W, const mesh::TriangleMesh& part_P,
                           const std::vector<Pose>& X_WP);

}  // namespace tdbd::reference

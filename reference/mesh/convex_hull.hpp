#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Computes the convex hull of points that are not all in one plane (CGAL, exact predicates), with
/// outward triangles. The mesh does not depend on the order of the points: vertices are sorted by
/// their coordinates, and planar faces are fans. CGAL's own triangulation of a planar face differs
/// from run to run.
mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace tdbd::reference

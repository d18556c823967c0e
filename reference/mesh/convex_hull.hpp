#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Convex hull of points that are not all in one plane (CGAL, exact predicates); outward triangles.
/// The same mesh whatever the order of the points: vertices in the order of their coordinates, plane
/// faces as fans. CGAL's own triangulation of a plane face differs from run to run.
mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace tdbd::reference

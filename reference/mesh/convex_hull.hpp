#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Convex hull of points that are not all in one plane (CGAL, exact predicates); outward triangles.
mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace tdbd::reference

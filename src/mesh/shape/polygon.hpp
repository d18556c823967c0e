#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Splits a simple polygon into triangles without new points and appends them. `corners` are
/// indices into `points`, at least three, counter-clockwise seen from outside; the triangles have
/// the same sense. A polygon whose fan about its first corner consists of proper triangles is split
/// into that fan. Any other, such as a concave one or one with corners on its sides, is split by
/// cutting ears in the plane of its area vector (Meisters 1975). A polygon without area, one that
/// crosses itself, and a concave one with more than 2000 corners become fans; the checks of the
/// mesh then report the triangles that are wrong.
void triangulate_polygon(const std::vector<Vec3>& points, const std::vector<int>& corners,
                         std::vector<Triangle>& triangles);

}  // namespace tdbd::mesh

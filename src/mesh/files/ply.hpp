#pragma once

#include <ostream>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Writes `m` as binary little-endian PLY, positions as doubles. CGAL's writer gives the same
/// records one number at a time.
void write_ply(std::ostream& out, const TriangleMesh& m);

}  // namespace tdbd::mesh

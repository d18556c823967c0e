#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Writes `m` as binary little-endian PLY with positions as doubles. The output equals that of
/// CGAL's writer, which writes one number at a time. Each comment is a line of the header.
void write_ply(std::ostream& out, const TriangleMesh& m,
               const std::vector<std::string>& comments = {});

}  // namespace tdbd::mesh

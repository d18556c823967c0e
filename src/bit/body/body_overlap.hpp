#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Volume (m3) that a closed convex mesh shares with any closed, outward-oriented mesh in the same
/// frame. A point is inside the second mesh if a ray from it along +z leaves that mesh once more
/// often than it enters. So the volume is a sum over the second mesh's triangles, with the sign of
/// the z component of their normals, of the part of the convex mesh that is vertically above each
/// triangle (one clip by four planes). Exact for the meshes.
double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed);

/// Volume (m3) of the cutters' parts with a density that lies inside the bit's bodies. It counts
/// twice in the mass because bodies have no pockets.
double cutters_in_body(const Bit& bit);

}  // namespace tdbd::bit

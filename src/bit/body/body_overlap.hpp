#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Volume (m3) that a closed convex mesh shares with any closed, outward oriented mesh in the same
/// frame. A point is inside the second when a ray from it along +z leaves it once more often than
/// it enters; so the volume is the sum over its triangles, with the sign of their normal's z, of
/// what the convex one has straight above each: one clip by four planes. Exact for the meshes.
double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed);

/// Volume (m3) of the cutters that lies inside the bit's bodies: without pockets it counts twice
/// in the mass. Of the cutters' parts that have a density.
double cutters_in_body(const Bit& bit);

}  // namespace tdbd::bit

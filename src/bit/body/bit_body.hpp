#pragma once

#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Makes the part bit-body: a solid of revolution about the bit's axis, in the bit frame, that
/// never cuts. Its meridian connects the tips, each moved into the bit along the profile's normal
/// by `setback` times its cutter's diameter; above them are the gage and the shank. It fills blades
/// and waterways, so its mass (`density` in kg/m3) is an upper estimate. `gage_radius` in m.
/// Thesis: 3.1; the shape is not in the thesis.
Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius);

/// Volume (m3) that a closed convex mesh shares with any closed, outward-oriented mesh in the same
/// frame. A point is inside the second mesh if a ray from it along +z leaves that mesh once more
/// often than it enters. So the volume is a sum over the second mesh's triangles, with the sign of
/// the z component of their normals, of the part of the convex mesh that is vertically above each
/// triangle (one clip by four planes). Exact for the meshes.
double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed);

/// Volume (m3) of the cutters' parts with a density that lies inside the bit's bodies. It counts
/// twice in the mass because bodies have no pockets.
double cutters_in_body(const Bit& bit);

/// Returns pairs (inner, outer) of indices into Bit::parts. Both parts have a density, and every
/// vertex of the inner part lies inside the outer part's mesh, so its volume counts twice in the
/// mass. Sorted by the inner part, then the outer part.
std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit);

}  // namespace tdbd::bit

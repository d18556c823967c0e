#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Makes the block of rock below an open surface: the surface, a vertical skirt down from its
/// boundary, and a flat bottom `depth` below the boundary (m; z points down). Normals point out of
/// the rock, as those of the surface (towards -z). The bottom is a fan about the boundary's mean.
/// So the boundary must be one loop at one z, star-shaped about its mean, and the surface must stay
/// inside it and above the bottom. Throws RunError if there is not exactly one loop, if it is not
/// horizontal or if the bottom is too high.
mesh::TriangleMesh close_surface(const mesh::TriangleMesh& open, double depth);

}  // namespace tdbd::reference

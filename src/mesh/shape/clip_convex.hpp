#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Clips a closed convex mesh to n.x <= b and closes it with a flat fan; n is a unit vector.
/// Vertices closer to the plane than 1e-12 of the size of the mesh count as lying on it. Pieces of
/// clipped triangles remain in their planes, so the result is convex. Returns an empty mesh if no
/// part is strictly inside, and `m` if no part is outside.
TriangleMesh clipped_convex(const TriangleMesh& m, const Vec3& n, double b);

}  // namespace tdbd::mesh

#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// The part of a closed convex mesh with n.x <= b, closed by a flat fan; n is a unit vector. Vertices closer to the plane
/// than 1e-12 of the mesh's size count as on it. Pieces of cut triangles stay in their planes, so the result is convex.
/// Empty if nothing lies strictly inside; the mesh itself if nothing lies outside.
TriangleMesh clipped_convex(const TriangleMesh& m, const Vec3& n, double b);

}  // namespace tdbd::mesh

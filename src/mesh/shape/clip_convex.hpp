#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// The part of a closed convex mesh on the inner side of a plane, n.x <= b, closed again by a flat
/// fan; n is a unit vector. Vertices closer to the plane than 1e-12 of the mesh's size count as on
/// it. Triangles that the plane cuts stay flat pieces of themselves, so the result is convex. Empty
/// when nothing lies strictly inside; the mesh itself when nothing lies outside.
TriangleMesh clipped_convex(const TriangleMesh& m, const Vec3& n, double b);

}  // namespace tdbd::mesh

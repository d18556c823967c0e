#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Whether x is inside a closed mesh, by the generalised winding number: the sum of the solid
/// angles of all triangles seen from x is 4 pi inside and 0 outside. On the surface the result is
/// arbitrary. x in the mesh's frame, m. The run time is proportional to the number of triangles.
bool inside(const mesh::TriangleMesh& closed, const Vec3& x);

/// Whether a part swept a rock vertex, and how far the vertex must move along its update direction.
struct SweptExit {
  bool swept = false;
  double t = 0.0;  ///< exit distance, in lengths of u (m when u is a unit vector); 0 if not swept
};

/// Twin of the exact swept test (rock (2) and rock (3); thesis: 4.1.1, 4.1.3). The part moves from
/// pose 0 to pose 1. Relative to it, the vertex moves from q0_P to q1_P and its update direction
/// from u0_P to u1_P (part frame, m), both linearly in tau in [0, 1].
///
/// Method: at the sub-poses tau = k / substeps, k = 0 ... substeps, all intervals of t >= 0 are
/// found in which q + t u is inside the part. The vertex is swept if one of them contains t = 0.
/// The exit is the end of the connected component of their union that contains t = 0. Two intervals
/// belong to one component if they overlap or if the gap between them is at most |q1 - q0| /
/// substeps, the distance that the vertex travels between two sub-poses.
///
/// Converges to the exact result as substeps grows. For a convex part and a constant direction it
/// converges from below, and an exact "not swept" is "not swept" here, too. A part thinner than
/// this distance may be missed; a narrower gap is bridged. The run time is proportional to substeps
/// x triangles x crossings.
SweptExit brute_force_exit(const mesh::TriangleMesh& part_P, const Vec3& q0_P, const Vec3& q1_P,
                           const Vec3& u0_P, const Vec3& u1_P, int substeps);

}  // namespace tdbd::reference

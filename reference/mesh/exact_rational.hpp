#pragma once

#include <CGAL/Gmpq.h>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Every double is a rational number; sums and products of rationals are exact.
using Rational = CGAL::Gmpq;

/// Exact signed volume of the cones from the origin to the triangles, m3: the enclosed volume of a
/// closed mesh, or the volume between an open mesh and the cone over its boundary.
Rational signed_volume_rational(const mesh::TriangleMesh& m);

/// Exact signed volume, m3, of the prisms x = (1 - zeta) x_before + zeta x_after that the triangles
/// span (rock (10); thesis: 4.3, figs. 4.23, 4.24). Positive along the normals. With a fixed
/// boundary it is signed_volume_rational(after) - signed_volume_rational(before). Throws RunError
/// if the two meshes do not have the same triangles.
Rational prism_volume_rational(const mesh::TriangleMesh& before, const mesh::TriangleMesh& after);

}  // namespace tdbd::reference

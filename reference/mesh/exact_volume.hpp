#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Twins of mesh::enclosed_volume and of the removed volume (rock (10); thesis: 4.3), in exact
/// rational arithmetic (exact_rational.hpp), rounded once at the end: the error is less than one
/// unit in the last place, regardless of cancellation. m3. The run time is about 10 us per
/// triangle.

/// Volume enclosed by a closed mesh; positive when the normals point outwards.
double enclosed_volume_exact(const mesh::TriangleMesh& closed);

/// Signed volume of an open surface: that of the cones from the origin to its triangles.
double signed_volume_exact(const mesh::TriangleMesh& open);

/// Volume between two surfaces with the same triangles: the sum of the prisms that the triangles
/// span. Positive where the surface moved against its normal. The rock's normal points out of the
/// rock, so this is the removed rock. With a fixed boundary: V(before) - V(after).
double removed_volume_exact(const mesh::TriangleMesh& before, const mesh::TriangleMesh& after);

}  // namespace tdbd::reference

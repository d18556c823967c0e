#pragma once

#include "mesh/triangle_mesh.hpp"
#include "reference/literature/surface/outline_nodes.hpp"
#include "reference/literature/surface/spoke_plane.hpp"

namespace tdbd::reference {

/// Computes the rock below a sheet (an oriented disc, normal out of the rock) in the half-plane of
/// a spoke: the line in which the plane cuts the sheet, extended horizontally outwards from the
/// sheet's rim, within the frame. All z of one radius are preserved. Throws std::invalid_argument
/// unless the plane meets the sheet in exactly one line from rim to rim.
PlanarRegion rock_section(const mesh::TriangleMesh& rock_W, const SpokePlane& plane,
                          const SpokeFrame& frame);

}  // namespace tdbd::reference

#pragma once

#include "bit/cone.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// Closed convex mesh of a tooth in its frame T, from -embedding to +protrusion. It is a stack of
/// outlines across Z, each a segment along X widened by a disc, whose corners share their normals;
/// so every side is flat. `facets` corners in an outline (a multiple of 4; a milled tooth has 4),
/// all on the tooth's true surface.
/// An insert is a cylinder with a half-ball, a ball-tipped cone or a chisel on top; a milled tooth
/// is a wedge from a rectangle to its crest.
mesh::TriangleMesh tooth_mesh(const ToothShape& shape, int facets);

}  // namespace tdbd::bit

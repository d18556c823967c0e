#pragma once

#include "bit/cone.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// Makes a closed convex mesh of a tooth in its frame T, from -embedding to +protrusion. An insert
/// is a cylinder with a hemisphere, a round-tipped cone or a chisel on top; a milled tooth is a
/// wedge from a rectangle to its crest. The mesh is a stack of outlines normal to Z. Each outline
/// is a segment along X widened by a disc, with corners at the same angles, so that every side is
/// flat. An outline has `facets` corners (a multiple of 4; a milled tooth has 4), all on the
/// tooth's true surface.
mesh::TriangleMesh tooth_mesh(const ToothShape& shape, int facets);

}  // namespace tdbd::bit

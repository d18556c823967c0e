#pragma once

#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// Selects at most `most` planes: the first six, then repeatedly the plane whose normal is farthest
/// from those already selected. The selection bounds the solid closely, and most outside points are
/// outside one of the first planes. The result is padded.
mesh::ConvexSolid spread_planes(const mesh::ConvexSolid& planes, std::size_t most);

}  // namespace tdbd::rock

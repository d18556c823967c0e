#pragma once

#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// At most `most` of the planes: the first six, then always the one whose normal is farthest from
/// those chosen. So few planes bound the solid tightly, and most of what is outside the solid is
/// outside one of the first. Padded.
mesh::ConvexSolid spread_planes(const mesh::ConvexSolid& planes, std::size_t most);

}  // namespace tdbd::rock

#pragma once

#include "mesh/surface.hpp"

namespace tdbd::bench {

/// The block of rock around a hole, closed as exact booleans require: the surface, a flat top from
/// the mouth of the hole out to `radius`, a side, and a bottom `depth` below the top (m).
mesh::TriangleMesh block_of_rock(const mesh::Surface& hole_W, double radius, double depth);

}  // namespace tdbd::bench

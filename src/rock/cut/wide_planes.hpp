#pragma once

#include "core/wide.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// Planes of a solid, n . x <= b, as many as lanes.
struct WidePlanes {
  Wide x, y, z, b;
};

/// The planes from column i on. For loops that are TDBD_WIDE.
inline void load(const mesh::ConvexSolid& s, std::size_t i, WidePlanes& planes) {
  TDBD_LOAD(planes.x, &s.nx[i]);
  TDBD_LOAD(planes.y, &s.ny[i]);
  TDBD_LOAD(planes.z, &s.nz[i]);
  TDBD_LOAD(planes.b, &s.b[i]);
}

}  // namespace tdbd::rock

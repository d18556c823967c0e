#pragma once

#include <array>
#include <cstddef>

#include "core/wide.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Slabs in single precision, relative to an origin.
struct SingleSlabs {
  std::array<Single, 3> nx{}, ny{}, nz{}, lo{}, hi{};
};

/// The slabs relative to an origin, widened by `slack` (m).
SingleSlabs about(const Vec3& origin_W, const std::array<Slab, 3>& slabs, double slack);

/// Eight places, one per lane.
struct WidePoints {
  WideSingle x, y, z;
};

/// Loads the places of a block of the index. Its columns are read as eight entries; the eighth is
/// meaningless.
inline void load(const VertexGrid::Block& block, WidePoints& p) {
  using Block = VertexGrid::Block;
  const char* bytes = reinterpret_cast<const char*>(&block);
  TDBD_LOAD(p.x, bytes + offsetof(Block, x));
  TDBD_LOAD(p.y, bytes + offsetof(Block, y));
  TDBD_LOAD(p.z, bytes + offsetof(Block, z));
  p.z[VertexGrid::block_size] = 0;  // a vertex number read as a subnormal would be slow
}

/// Flags the places that lie between all slabs. A place that is `nowhere` is not flagged. For loops
/// that are TDBD_WIDE.
inline void flag_between(const WidePoints& p, const SingleSlabs& s, WideFlags& in) {
  in = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle along = s.nx[k] * p.x + s.ny[k] * p.y + s.nz[k] * p.z;
    in &= (along >= s.lo[k]) & (along <= s.hi[k]);
  }
}

}  // namespace tdbd::rock

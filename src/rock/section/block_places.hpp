#pragma once

#include <cstddef>

#include "core/wide.hpp"
#include "rock/cut/hull_sieve.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Places in the frame of a part, m, in single precision. Passed by reference: see core/wide.hpp.
struct WideBlock {
  WideSingle x, y, z;
};

/// The vertices of a block of the index, which is in the frame W, in the frame P. The eighth has no
/// meaning. For functions that are TDBD_WIDE.
TDBD_INLINE void put_in_frame(const VertexGrid::Block& block, const SingleFrame& X_PW,
                              WideBlock& q_P) {
  using Block = VertexGrid::Block;
  const char* bytes = reinterpret_cast<const char*>(&block);
  WideSingle x, y, z;
  TDBD_LOAD(x, bytes + offsetof(Block, x));
  TDBD_LOAD(y, bytes + offsetof(Block, y));
  TDBD_LOAD(z, bytes + offsetof(Block, z));
  z[VertexGrid::block_size] = 0;  // a vertex number read as subnormal would be slow
  const auto& R = X_PW.R;
  q_P = {R[0] * x + R[1] * y + R[2] * z + X_PW.p[0], R[3] * x + R[4] * y + R[5] * z + X_PW.p[1],
         R[6] * x + R[7] * y + R[8] * z + X_PW.p[2]};
}

}  // namespace tdbd::rock

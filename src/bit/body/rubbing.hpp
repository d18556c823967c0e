#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How near a part comes to the rock that the cutters leave in steady drilling.
struct Rubbing {
  double clearance = 0.0;  ///< m, along the axis, the least; negative: the part is in the rock
  Vec3 clearance_at_B{0, 0, 0};   ///< m, the vertex with the least clearance
  double touching_advance = 0.0;  ///< m per revolution, the least at which a vertex touches
  Vec3 touching_at_B{0, 0, 0};    ///< m, that vertex
  std::size_t vertices = 0;       ///< that were measured
  std::size_t over_uncut = 0;     ///< left out: at their radius no cutter cuts
};

/// The radial plane (engagement.hpp), seen by a surface that does not cut. At the radius of a
/// vertex at depth z, cutter c reaches z_c and passed a share f_c of a revolution before; the bit
/// has sunk by f_c advance since. So the rock left over the vertex stands at
/// max over c of z_c - f_c advance, and the vertex touches it at the advance
///   max over c of (z_c - z) / f_c,
/// the depth of cut that the body controls. Vertices only; rims are interpolated between columns of
/// at most `column_width` (m). A part without vertices over cut rock keeps the zeros.
Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width);

}  // namespace tdbd::bit

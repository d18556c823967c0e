#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How close a part comes to the rock that the cutters leave in steady drilling.
struct Rubbing {
  double clearance = 0.0;  ///< m, the least, along the axis; negative: the part is in the rock
  Vec3 clearance_at_B{0, 0, 0};   ///< m, the vertex with the least clearance
  double touching_advance = 0.0;  ///< m per revolution, the least at which a vertex touches
  Vec3 touching_at_B{0, 0, 0};    ///< m, that vertex
  std::size_t vertices = 0;       ///< vertices that were measured
  std::size_t over_uncut = 0;     ///< vertices left out: no cutter cuts at their radius
};

/// The radial-plane analysis (engagement.hpp) for a surface that does not cut, bit (7). `advance`
/// (m per revolution) sets the clearance; the least touching advance is the depth of cut that the
/// body controls. Vertices only; rims are interpolated between columns of at most `column_width`
/// (m). A part without vertices over cut rock keeps the zeros. Ours.
Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width);

}  // namespace tdbd::bit

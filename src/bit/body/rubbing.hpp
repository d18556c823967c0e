#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How close a part comes to the rock that the cutters leave in steady drilling.
struct Rubbing {
  double clearance = 0.0;  ///< m, the least, along the axis; negative: the part is in the rock
  Vec3 clearance_at_B{0, 0, 0};   ///< m, the point with the least clearance
  double touching_advance = 0.0;  ///< m per revolution, the least at which a point touches
  Vec3 touching_at_B{0, 0, 0};    ///< m, that point
  std::size_t points = 0;         ///< points that were measured
  std::size_t over_uncut = 0;     ///< points left out: no cutter cuts at their radius
};

/// The radial-plane analysis (engagement.hpp) for a surface that does not cut, bit (7). `advance`
/// (m per revolution) sets the clearance; the least touching advance is the depth of cut that the
/// body controls. Of all vertices and, every millimetre, of those facets that face the rock and have a
/// corner that touches early; rims are interpolated between columns of at most `column_width` (m). A part without
/// points over cut rock keeps the zeros. Ours.
Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width);

/// Areas (m2) of the part that lie in the rock at steady advances (m per revolution), projected along
/// the axis, bit (7): what its facets that face the rock have below it, depths linear over each. No
/// facet over rock that no cutter cuts. Ours.
std::vector<double> rubbing_areas(const std::vector<Cutter>& cutters, const Part& part,
                                  const std::vector<double>& advances, double column_width);

}  // namespace tdbd::bit

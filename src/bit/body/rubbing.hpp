#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The distance of a part from the rock that the cutters leave in steady drilling.
struct Rubbing {
  double clearance = 0.0;        ///< m, smallest, along the axis; negative: the part is in the rock
  Vec3 clearance_at_B{0, 0, 0};  ///< m, the point with the least clearance
  double touching_advance = 0.0;  ///< m per revolution, smallest advance at which a point touches
  Vec3 touching_at_B{0, 0, 0};    ///< m, that point
  std::size_t points = 0;         ///< number of measured points
  std::size_t over_uncut = 0;     ///< number of points omitted: no cutter cuts at their radius
};

/// Radial-plane analysis (bit_analysis.hpp) for a surface that does not cut, bit (7). `advance` (m
/// per revolution) determines the clearance. The smallest touching advance is the depth of cut that
/// the body controls. Measured at all vertices and, every millimetre, on those facets that face the
/// rock and have a corner that touches early. Rims are interpolated between columns of at most
/// `column_width` (m). The result of a part without points over cut rock is zero. Not in the
/// thesis.
Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width);

/// Areas (m2) of the part that lie in the rock at steady advances (m per revolution), projected
/// along the axis, bit (7): for its facets that face the rock, the part below which there is rock,
/// with depths linear over each facet. Facets over rock that no cutter cuts do not count. Not in
/// the thesis.
std::vector<double> rubbing_areas(const std::vector<Cutter>& cutters, const Part& part,
                                  const std::vector<double>& advances, double column_width);

}  // namespace tdbd::bit

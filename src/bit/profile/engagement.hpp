#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// What each cutter cuts in steady drilling, in the order of the cutters; and how many share a
/// radius.
struct Engagement {
  std::vector<double> area;    ///< m2, cut area in the (r, z) half-plane
  std::vector<double> volume;  ///< m3 per revolution
  std::vector<int> cutting;    ///< in each column of radii: cutters that remove rock there
  double column_width = 0.0;   ///< m; column k is centred at (k + 1/2) column_width
};

/// The classical radial plane (Warren and Sinor 1986) in closed form: the bit turns steadily and
/// sinks by `advance` (m > 0) a revolution. At a radius where the cutters' rims reach the depths
/// z_c, cutter c' passes a share f of a revolution before c, and the height that c removes is
///   h_c = max(0, min over c' of z_c - z_c' + advance f),   f = 1 for c itself,
/// so the heights add up to the advance. Area and volume are sums of h and 2 pi r h over columns
/// of at most `column_width` (m) from the axis to the widest rim. Chamfers lie inside the rim.
/// Without cutters there are no columns.
Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width);

}  // namespace tdbd::bit

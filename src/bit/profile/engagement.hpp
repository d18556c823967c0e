#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Width (m) of the columns in reports.
inline constexpr double report_column_width = 0.1e-3;

/// What each cutter cuts in steady drilling, in the order of the cutters, and how many cutters cut
/// at each radius.
struct Engagement {
  std::vector<double> area;    ///< m2, cut area in the (r, z) half-plane
  std::vector<double> volume;  ///< m3 per revolution
  std::vector<int> cutting;    ///< per column of radius: cutters that remove rock there
  double column_width = 0.0;   ///< m; column k is centred at (k + 1/2) column_width
};

/// Classical radial-plane analysis (Warren and Sinor 1986) in closed form, bit (10). The bit turns
/// steadily and moves down by `advance` (m > 0) per revolution. Area and volume are sums of h dr
/// and 2 pi r h dr over columns of at most `column_width` (m) from the axis to the widest rim.
/// Chamfers lie inside the rim. Without cutters there are no columns.
Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width);

}  // namespace tdbd::bit

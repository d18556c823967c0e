#pragma once

#include <limits>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Number of points of a turned outline where its accuracy matters.
inline constexpr int rim_points = 1440;

/// The rim of a cutter rotated into one half-plane about the bit's axis, m: x is the radius, y the
/// azimuth (rad, within half a turn of the cutter's), z the bit's z. Has `points` points, starting
/// at the tip. Where the cutter is worn, the rim is moved back along the profile's normal to its
/// flat.
std::vector<Vec3> turned_outline(const Cutter& c, int points);

/// The deepest point of a cutter's rim at one radius.
struct RimReach {
  double z = -std::numeric_limits<double>::infinity();  ///< m, bit frame
  double azimuth = 0.0;                                 ///< rad

  /// Whether the rim extends over this radius.
  bool reached() const { return z != -std::numeric_limits<double>::infinity(); }
};

/// The reach of every cutter, at the centres of equal columns of radius from the axis to the widest
/// rim.
struct RimReaches {
  std::vector<std::vector<RimReach>> of_cutter;  ///< [cutter][column]
  double width = 0.0;                            ///< m; column k is centred at (k + 1/2) width
};

/// Computes the reaches in columns of at most `column_width` (m). Chamfers lie inside the rim.
RimReaches rim_reaches(const std::vector<Cutter>& cutters, double column_width);

}  // namespace tdbd::bit

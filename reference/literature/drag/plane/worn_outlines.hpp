#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// Projections of the cutters along the motion (ellipses) in columns of the (r, z) half-plane;
/// column k has the radius (k + 1/2) column. Computed once and used for every state of wear. z
/// down, from the nose tip.
struct WornOutlines {
  double column = 0.0;  ///< m
  /// The position of a cutter, and the columns that it covers.
  struct Place {
    double tip_radius = 0.0, tip_depth = 0.0;              ///< m
    double sine = 0.0, cosine = 0.0;                       ///< of the profile angle
    double turn = 0.0;                                     ///< azimuth, in turns, in [0, 1)
    std::size_t first_column = 0, columns = 0, begin = 0;  ///< `begin`: in `lower` and `upper`
  };
  std::vector<Place> places;         ///< of the cutters, in their order
  std::vector<double> lower, upper;  ///< m, depths of the two branches, cutter after cutter
  std::vector<std::size_t> order;    ///< of the passes in a turn: descending azimuth
  std::size_t most_columns = 0;
};

/// Throws InputError for no cutters, a column that is not > 0 or a cutter without a diameter.
WornOutlines worn_outlines(const std::vector<bit::Cutter>& cutters, double column);

/// What each cutter cuts in one revolution of steady drilling.
struct WornCut {
  std::vector<double> area;    ///< m2, in the half-plane
  std::vector<double> volume;  ///< m3 per revolution
  std::vector<double> bottom;  ///< m, depth of the bottom in every column; -infinity: not reached
};

/// The planar model of Warren and Sinor with outlines that end at wear flats. `worn` (m): what
/// every cutter lost along the profile's normal. `advance`: m per revolution. The bottom after one
/// revolution is steady, because each pass of a cutter is deeper than its last one by the advance
/// everywhere; so the second revolution is reported. Reuses the arrays of `cut`.
void cut_worn(const WornOutlines& outlines, const std::vector<double>& worn, double advance,
              WornCut& cut);

}  // namespace tdbd::reference

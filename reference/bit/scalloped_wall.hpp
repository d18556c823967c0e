#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// The wall that steady drilling leaves, over one advance. In every half-plane it repeats the same
/// curve, lower by the advance with each turn and shifted with the azimuth. Where two passes of the
/// gage cutters meet, a cusp of rock remains. Its underside overhangs, so a height field removes
/// it, as does pi R^2 d. Does not use a rock mesh.
struct ScallopedWall {
  std::vector<double> radius;  ///< m, at the centres of equal height steps of one advance
  double volume = 0.0;         ///< m3 per revolution: integral of pi r^2 over one advance
  double reach = 0.0;          ///< m, largest radius
};

/// Computes the wall from all edges of the cutting parts, sampled at half a row's height. A point
/// at azimuth phi and height z is in the half-plane at the height z - advance phi / (2 pi). The
/// error is of first order in the height of the rows. The cutters must leave no radius uncut.
/// `advance`: m per revolution.
ScallopedWall scalloped_wall(const bit::Bit& bit, double advance, int rows);

}  // namespace tdbd::reference

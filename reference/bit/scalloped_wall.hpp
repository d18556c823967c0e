#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// The wall that steady drilling leaves, over one advance: in every half-plane the same curve again
/// and again, moved down by the advance from turn to turn and shifted with the azimuth. Where two
/// passes of the gage's cutters meet, a cusp of rock stays: its underside hangs over, so a height
/// field takes it away, and so does pi R^2 d. No rock mesh is needed.
struct ScallopedWall {
  std::vector<double> radius;  ///< m, at the middles of equal heights of one advance
  double volume = 0.0;         ///< m3 a revolution: integral of pi r^2 over one advance
  double reach = 0.0;          ///< m, largest radius
};

/// From all edges of the cutting parts, sampled at half a row's height: for a point at azimuth phi
/// and height z the half-plane's height is z - advance phi / (2 pi). The error is of order one in
/// the rows' height. The cutters must leave no radius uncut. advance in m a revolution.
ScallopedWall scalloped_wall(const bit::Bit& bit, double advance, int rows);

}  // namespace tdbd::reference

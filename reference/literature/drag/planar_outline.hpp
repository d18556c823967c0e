#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What every cutter cuts in steady drilling, in the order of the cutters.
struct PlanarCut {
  std::vector<double> area;    ///< m2, in the (r, z) half-plane
  std::vector<double> volume;  ///< m3 per revolution
};

/// The planar model of Warren and Sinor (1986): each cutter's rim is drawn in the (r, z) half-plane
/// as the ellipse that it shows along the motion (not turned about the axis), and the passes of six
/// revolutions, in order of time, remove what lies between them and the bottom. The last revolution
/// is reported. `advance`: m per revolution; `column`: m, of radius.
PlanarCut planar_cut(const std::vector<bit::Cutter>& cutters, double advance, double column);

}  // namespace tdbd::reference

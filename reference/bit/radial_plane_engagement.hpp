#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What each cutter removes in steady drilling. Indices are those of Bit::cutters.
struct Engagement {
  std::vector<double> volume_per_revolution;  ///< m3
  std::vector<double> mean_area;  ///< m2, cut area in the (r, z) half-plane, mean over a revolution
  double total = 0.0;             ///< sum of volume_per_revolution, m3
  double reach = 0.0;             ///< m, largest radius of any cutting cutter
};

/// Computes the classical kinematic cut of every cutter at constant advance per revolution (m),
/// without any rock mesh (Warren and Sinor 1986). It is the independent check of the rock volumes
/// removed by each cutter.
///
/// In a fixed half-plane through the bit's axis, a point of the bit at azimuth phi and height z
/// passes when the bit has turned by theta = -phi + 2 pi k (the bit turns about +z), at the depth z
/// - advance phi / (2 pi) + k advance (it advances along +z, down). At each radius a cutter leaves
/// the largest depth of its points. The passes of five revolutions, in order of time, each remove
/// what lies between their depth and the largest depth before; the last revolution is reported.
///
/// Radii are columns of equal width <= radial_spacing (m) from the axis to `reach`. Depths are
/// evaluated at the columns' centres, from all mesh edges of the cutters' cutting parts, sampled at
/// half that spacing with linear interpolation. Depths inside triangles are not sampled: the error
/// for a facetted part is the sagitta of a triangle's arc about the bit's axis. If the cutters
/// leave no radius uncut, total = pi reach^2 advance, for any arrangement of the cutters. Throws
/// RunError if the last two revolutions differ. The run time is proportional to edge length /
/// spacing.
Engagement radial_plane_engagement(const bit::Bit& bit, double advance, double radial_spacing);

}  // namespace tdbd::reference

#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What each cutter removes in steady drilling. Indices are those of Bit::cutters.
struct Engagement {
  std::vector<double> volume_per_revolution;  ///< m3
  std::vector<double> mean_area;  ///< cut area in the (r, z) half-plane, mean of a revolution, m2
  double total = 0.0;             ///< sum of volume_per_revolution, m3
  double reach = 0.0;             ///< largest radius of any cutting cutter, m
};

/// The classical kinematic cut of every cutter at constant advance per revolution (m), without any
/// rock mesh (Warren and Sinor 1986): the independent check of the rock's removed volumes by
/// cutter.
///
/// In a fixed half-plane through the bit's axis, a point of the bit at azimuth phi and height z
/// passes when the bit has turned by theta = -phi + 2 pi k (the bit turns about +z), at the depth
/// z - advance phi / (2 pi) + k advance (it advances along +z, down). At each radius a cutter
/// leaves the deepest of its points' depths. Passes of five revolutions, in order of time, each
/// remove what lies between their depth and the deepest before; the last revolution is reported.
///
/// Radii are columns of equal width <= radial_spacing (m) from the axis to `reach`; depths are
/// taken at the columns' centres, from all mesh edges of the cutters' cutting parts, sampled at
/// half that spacing and linear in between. Depths inside triangles are not sampled: of a facetted
/// part the error is the sagitta of a triangle's arc about the bit's axis.
/// If the cutters leave no radius uncut, total = pi reach^2 advance, whatever their places.
/// Throws RunError if the last two revolutions differ. Cost: edge length / spacing.
Engagement radial_plane_engagement(const bit::Bit& bit, double advance, double radial_spacing);

}  // namespace tdbd::reference

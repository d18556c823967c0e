#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The smallest distance of a leg and a part of a cone in a full turn of the cone, and its place.
struct LegClearance {
  std::string leg;        ///< "leg-1"
  std::string part;       ///< "cone-1/body", "cone-2/row-4/tooth-1"
  double distance = 0.0;  ///< m; negative: depth of the leg in the volume that the part sweeps
  double angle = 0.0;     ///< rad, of the cone when its part is at that place
  Vec3 place_B = Vec3::Zero();
};

/// Formats a clearance: "an overlap of 1.203 mm of leg-1 and cone-2/row-4/tooth-1 (at 34.2 deg) at
/// (1.0, 2.0, 3.0) mm", or "a gap of ...". The angle is that of the cone; the place is in the bit's
/// frame.
std::string clearance_text(const LegClearance& c);

/// For every leg and every cone of a bit, returns every overlap of the leg with the volume swept by
/// the cone's shell or a row of its teeth, or, if there is none, the smallest gap between the two,
/// to clearance_tolerance. Branch and bound over the leg's triangles: the signed distance from a
/// solid of revolution changes by no more than the point moves. Conservative by the slack of
/// swept_meridian; a lower bound if most_patches is reached. A cone completely inside a leg is not
/// detected. Cones without a shell are skipped. Sorted by distance.
std::vector<LegClearance> leg_clearances(const Bit& bit);

}  // namespace tdbd::bit

#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A part's frame in the bit frame with the bit's cones at these angles (rad about their Z, one per
/// cone): X_BK(phi) X_KP for the parts of a cone, X_BP for all others; bit (2). With a pose of the
/// bit, X_WP = X_WB part_pose. Parts of one cone move as one rigid body.
Pose part_pose(const Bit& bit, const Part& part, const std::vector<double>& cone_angles);

/// Returns the bit with its cones at these angles.
Bit turned(Bit bit, const std::vector<double>& cone_angles);

}  // namespace tdbd::bit

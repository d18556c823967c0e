#pragma once

#include "bit/cone.hpp"

namespace tdbd::bit {

/// Frame K of a cone in the bit frame at the cone's angle phi (rad, about K's Z). Z is along the
/// journal, from outside the bit towards its axis and down; at azimuth 0, without skew, it is (-cos
/// J, 0, sin J) with J the journal angle. Without an offset, Z meets the bit's axis at the foot.
/// The chain from the bit to the cone is
///   Rz(azimuth)  offset along Y, foot  Rz(skew)  Ry(J - pi/2)  apex along Z  Rz(phi)
/// A bit that rotates about +z rolls its cones with a negative phi'. A point of a cone moves by bit
/// (2), with s = K's Z.
Pose cone_pose(const ConeLayout& cone, double phi);

/// The same for a cone of a bit, from its frame at angle 0.
Pose cone_pose(const Cone& cone, double phi);

}  // namespace tdbd::bit

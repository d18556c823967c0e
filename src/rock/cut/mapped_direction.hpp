#pragma once

#include "rock/cut/group_motion.hpp"

namespace tdbd::rock {

/// The update direction of a group at a rock vertex x, unit, in space. Thesis: 4.1.2.3, 4.1.3.2.
///   Ur = Rz(azimuth of x in frame D at pose 1) U,   D: GroupMotion, the bit's where it is upright
/// For a group with a core, U is the outward normal of the solids of equal distance from the core,
/// where x stands halfway through the step, in the half-plane through D's axis and x, clamped
/// to outward and down (formulation 2.3, reconstructed):
///   n = q - nearest point of the core to q,  q = (q0 + q1)/2,  U ~ (max(n_r, 0), max(n_z, 0))
/// and the group's one direction where both vanish: beside the core, above it and inwards.
Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

}  // namespace tdbd::rock

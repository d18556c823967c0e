#pragma once

#include "rock/cut/group_motion.hpp"

namespace tdbd::rock {

/// Returns the update direction of a group at a rock vertex x: a unit vector in W, rock (8).
/// Thesis: 4.1.2.3, 4.1.3.2.
///   Ur = Rz(azimuth of x in frame D at pose 1) U,   D: see GroupMotion
/// For a group with a core, U is the outward normal, at x's place halfway through the step, of the
/// surfaces of equal distance from the core. It is taken in the half-plane through D's axis and x
/// and clamped to outward and down, rock (9) (reconstructed):
///   n = q - nearest point of the core to q,  q = (q0 + q1)/2,  U ~ (max(n_r, 0), max(n_z, 0))
/// If both components vanish (above the core and on its inner side), U is the group's fixed
/// direction.
Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

}  // namespace tdbd::rock

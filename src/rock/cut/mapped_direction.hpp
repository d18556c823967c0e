#pragma once

#include "rock/cut/group_motion.hpp"

namespace tdbd::rock {

/// The update direction of a group at a rock vertex x, unit, in space, rock (8). Thesis: 4.1.2.3,
/// 4.1.3.2.
///   Ur = Rz(azimuth of x in frame D at pose 1) U,   D: see GroupMotion
/// For a group with a core, U is the outward normal of the surfaces of equal distance from the core
/// at x's place halfway through the step, in the half-plane through D's axis and x, clamped to
/// outward and down, rock (9) (reconstructed):
///   n = q - nearest point of the core to q,  q = (q0 + q1)/2,  U ~ (max(n_r, 0), max(n_z, 0))
/// Where both vanish (above the core and inwards of it) U is the group's fixed direction.
Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

}  // namespace tdbd::rock

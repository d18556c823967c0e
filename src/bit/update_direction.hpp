#pragma once

#include "core/types.hpp"

namespace tdbd::bit {

/// The direction e of eq. 4.2 for inside cutters. Straight down is the default (reconstructed). +X
/// and -X are the two readings of the thesis's formula: our copy of the text omits minus signs
/// elsewhere.
enum class InsideRule { down, plus_x, minus_x };

/// How update directions are chosen. `hybrid` is eq. 4.2; the others are the two extremes with
/// which figs. 4.7 to 4.9 of the thesis compare it.
enum class DirectionRule { hybrid, all_down, along_profile };

/// Returns the direction in which a cutter moves rock vertices, at azimuth 0: a unit vector in the
/// bit's X-Z plane; bit (8). With R the rotation about z that moves the cutter's origin to the
/// plane's +X side:
///   U~ = proj_XZ(-R Z)                                  (4.1)
///   U = U~/|U~| if U~.x > 0 (outside cutters), otherwise e  (4.2)
/// A cutter on the axis is treated as at azimuth 0. Throws InputError if the rule is along_profile
/// and -Z of the cutter points sideways (U~ = 0). Thesis: 4.1.2.1.
Vec3 update_direction(const Pose& X_BC, DirectionRule rule, InsideRule inside);

/// Applies eq. 4.2 to a given U~, which lies in the X-Z plane and may have any length.
Vec3 update_direction(const Vec3& u, DirectionRule rule, InsideRule inside);

}  // namespace tdbd::bit

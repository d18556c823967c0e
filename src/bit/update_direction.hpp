#pragma once

#include "core/pose.hpp"

namespace tdbd::bit {

/// The direction e of eq. 4.2 for inside cutters. Straight down is the default (reconstructed); +X
/// and -X are the two readings of the thesis's formula, whose minus signs our text drops elsewhere.
enum class InsideRule { down, plus_x, minus_x };

/// How update directions are chosen: hybrid is eq. 4.2; the others are the two extremes with which
/// figs. 4.7 to 4.9 of the thesis compare it.
enum class DirectionRule { hybrid, all_down, along_profile };

/// Direction in which a cutter moves rock vertices, at azimuth 0: unit, in the bit's X-Z plane; bit
/// (8). With R the rotation about z that brings the cutter's origin to the plane's +X side:
///   U~ = proj_XZ(-R Z)                                  (4.1)
///   U = U~/|U~| if U~.x > 0 (outside cutters), e if not  (4.2)
/// A cutter on the axis counts as at azimuth 0. Throws InputError when along_profile meets a cutter
/// whose -Z points sideways (U~ = 0). Thesis: 4.1.2.1.
Vec3 update_direction(const Pose& X_BC, DirectionRule rule, InsideRule inside);

/// Eq. 4.2 for a known U~, which lies in the X-Z plane and may have any length.
Vec3 update_direction(const Vec3& u, DirectionRule rule, InsideRule inside);

}  // namespace tdbd::bit

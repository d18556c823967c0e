#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// Frame T of a row's tooth at an angle (rad) about the cone's Z, in K: origin on the shell (less
/// the row's sink), Z the shell's normal turned by the row's lean, X along the meridian towards the
/// base.
Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle);

/// The parts cone-K/body and cone-K/row-J/tooth-I (K, J, I from 1): closed meshes at the cone's
/// angle 0. The body cuts only if the layout says so; the teeth always do. `index`: the cone's
/// index in the bit (Part::cone). The teeth's update directions are direct_teeth's to set. Thesis:
/// 3.1, fig. 3.5.
std::vector<Part> cone_parts(const Cone& cone, int index);

/// The meridian of what the row's teeth sweep in a full turn of the cone.
Meridian row_meridian(const ConeLayout& cone, const ToothRow& row);

/// Angles (rad, rising, in [0, 2 pi)) of `teeth` teeth, starting at `first_angle`. The gaps between
/// them have the ratios of `pattern`, which is repeated as needed and may be cut short; an empty
/// pattern means equal gaps. All gaps together are one turn.
std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern);

}  // namespace tdbd::bit

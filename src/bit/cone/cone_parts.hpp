#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// Frame T of a row's tooth at an angle (rad) about the cone's Z, in K: origin on the shell,
/// lowered by the row's sink; Z is the shell's normal rotated by the row's lean; X along the
/// meridian towards the base.
Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle);

/// Makes the parts cone-K/body and cone-K/row-J/tooth-I (K, J, I from 1): closed meshes at the
/// cone's angle 0. The body cuts only if the layout requires it; the teeth always cut. `index`: the
/// cone's index in the bit (Part::cone). direct_teeth sets the teeth's update directions. Thesis:
/// 3.1, fig. 3.5.
std::vector<Part> cone_parts(const Cone& cone, int index);

/// The meridian of the volume that the row's teeth sweep in a full turn of the cone.
Meridian row_meridian(const ConeLayout& cone, const ToothRow& row);

/// Angles (rad, ascending, in [0, 2 pi)) of `teeth` teeth, starting at `first_angle`. The gaps
/// between them have the ratios of `pattern`, which is repeated as needed and may be truncated. An
/// empty pattern means equal gaps. The sum of all gaps is one turn.
std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern);

}  // namespace tdbd::bit

#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// Frame T of a row's tooth at an angle about the cone's Z, in K: origin on the shell (less what
/// the row is sunk), Z the shell's normal turned by the row's lean, X along the meridian outwards.
Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle);

/// cone-K/body and cone-K/row-J/tooth-I, closed meshes at the cone's angle 0 (K, J, I from 1). The
/// body never cuts; the teeth do. `index`: the cone's, Part::cone. Inner rows move rock straight
/// down; teeth at the gage along their own axis in the meridian plane of the bit, clamped to
/// outward and down (formulation 2.3; reconstructed). Thesis: 3.1, fig. 3.5.
std::vector<Part> cone_parts(const Cone& cone, int index);

/// What the row's teeth sweep in a full turn of the cone.
Meridian row_meridian(const ConeLayout& cone, const ToothRow& row);

}  // namespace tdbd::bit

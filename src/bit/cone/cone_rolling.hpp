#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {

/// Where a tooth of a cone meets rock, and how much this place resists slip.
struct ConeContact {
  Vec3 x_B = Vec3::Zero();
  double weight = 0.0;  ///< any unit; removed volume in a run
};

/// What the contacts of a cone ask of its speed: phi' = -moment / inertia. Sums may be added and
/// scaled.
struct SlipBalance {
  double moment = 0.0;   ///< sum w s . (r x v), v the contact's velocity when the cone rests
  double inertia = 0.0;  ///< sum w |s x r|^2
};

/// Resistance opposite to slip and linear in it: the contact i is pushed by -w_i (v_i + phi' s x
/// r_i) with s the cone's Z, r_i from a point of the journal, v_i what the bit's twist gives it.
/// The torque about the journal vanishes, and sum w_i |v_i + phi' s x r_i|^2 is least, for
///   phi' = - sum w_i s . (r_i x v_i) / sum w_i |s x r_i|^2                       [R]
/// X_BK may stand at any cone angle.
SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts);

/// The point of a tooth that is farthest along its Z, in its frame T: on the axis, at the height of
/// its mesh.
Vec3 tooth_tip_P(const Part& tooth);

/// Speed over the bit's at which the cone's row at the gage rolls on the bottom without slip
/// (RowMeasures::rolling_ratio); of several rows, or of a cone without one, the row that is
/// farthest from the bit's axis. Usual: 1.2 to 1.5 (remembered, without a source).
double rolling_ratio_of_gage_row(const Cone& cone);

}  // namespace tdbd::bit

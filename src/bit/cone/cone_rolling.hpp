#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {

/// Where a tooth of a cone meets rock, and how strongly the rock resists slip there.
struct ConeContact {
  Vec3 x_B = Vec3::Zero();
  double weight = 0.0;  ///< any unit; removed volume in a run
};

/// What the contacts of a cone require of its speed: phi' = -moment / inertia. Balances may be
/// added and scaled.
struct SlipBalance {
  double moment = 0.0;   ///< sum w s . (r x v), v the contact's velocity on a cone at rest
  double inertia = 0.0;  ///< sum w |s x r|^2
};

/// The balance of a cone's contacts: at the speed of bit (13) the torque of a resistance linear in
/// slip vanishes about the journal. The contact i is pushed by -w_i (v_i + phi' s x r_i), with s
/// the cone's Z, r_i from a point of the journal, v_i from the bit's twist. X_BK may stand at any
/// cone angle. Reconstructed.
SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts);

/// The tip of a tooth in its frame T, m: on its axis, at the height of its mesh.
Vec3 tooth_tip_P(const Part& tooth);

/// The cone's speed over the bit's at which its gage row rolls on the bottom without slip
/// (RowMeasures::rolling_ratio). Among several gage rows, or without any, the row farthest from the
/// bit's axis counts; for a cone of solids, without rows, Cone::rolling_ratio. Usual values: 1.2 to
/// 1.5 (from memory, without a source).
double rolling_ratio_of_gage_row(const Cone& cone);

/// The same of a cone whose shape is known from its parts alone (ours): that of the tooth whose tip,
/// where it is deepest, is farthest from the bit's axis. A tip is a tooth's vertex farthest from the
/// journal's axis. Without teeth all parts that cut count; 0 if there are none. `index`: of the cone.
double rolling_ratio_of_parts(const Cone& cone, int index, const std::vector<Part>& parts);

}  // namespace tdbd::bit

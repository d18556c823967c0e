#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {

/// A contact of a tooth with rock, and the resistance of the rock against slip there.
struct ConeContact {
  Vec3 x_B = Vec3::Zero();
  double weight = 0.0;  ///< in any unit; the removed volume in a run
};

/// The balance of moments that determines a cone's speed: phi' = -moment / inertia. Balances may be
/// added and scaled.
struct SlipBalance {
  double moment = 0.0;   ///< sum w s . (r x v), v: the contact's velocity if the cone did not turn
  double inertia = 0.0;  ///< sum w |s x r|^2

  template <class Archive>
  void serialize(Archive& a) {
    a(moment, inertia);
  }
};

/// Computes the balance of a cone's contacts. At the speed of bit (13) the torque about the journal
/// of a resistance linear in slip is zero. Contact i is subject to the force -w_i (v_i + phi' s x
/// r_i), with s the cone's Z, r_i from a point of the journal and v_i from the bit's twist. X_BK
/// may be at any cone angle. Reconstructed.
SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts);

/// The tip of a tooth in its frame T, m: on its axis, at the height of its mesh.
Vec3 tooth_tip_P(const Part& tooth);

/// The ratio of the cone's speed to the bit's at which its gage row rolls on the bottom without
/// slip (RowMeasures::rolling_ratio). Of several gage rows, or if there is none, the row farthest
/// from the bit's axis is used; for a cone of solids, without rows, Cone::rolling_ratio. Usual
/// values: 1.2 to 1.5 (from memory, without a source).
double rolling_ratio_of_gage_row(const Cone& cone);

/// The same for a cone whose shape is known only from its parts: the ratio of the tooth whose tip,
/// where it is deepest, is farthest from the bit's axis. A tip is a tooth's vertex farthest from
/// the journal's axis. Without teeth, all cutting parts count; 0 if there are none. `index`: of the
/// cone. Not in the thesis.
double rolling_ratio_of_parts(const Cone& cone, int index, const std::vector<Part>& parts);

}  // namespace tdbd::bit

#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A row of a rolling cone: the tips of its teeth in the cone's frame, that frame in the bit frame
/// at angle 0, the ratio of cone speed to bit speed, and the distance (m) within which one print
/// falls into another.
struct RolledRow {
  Pose X_BK;
  std::vector<Vec3> tips_K;
  double speed = 0.0;
  double near = 0.0;
};

/// One touchdown of a tip.
struct RolledPrint {
  double turned = 0.0;        ///< rad, of the bit
  Vec3 place = Vec3::Zero();  ///< m, in the hole, at z = 0
};

/// Returns the places where tips pass their lowest point while the bit turns from `from` to `to`
/// (rad). The bit and its cone are rotated in small steps, every tip's height is followed, and a
/// minimum between two steps is refined by ternary search.
std::vector<RolledPrint> rolled_prints(const RolledRow& row, double from, double to);

/// Share of the prints of rows[own] within `revolutions` turns that are near any print of any row
/// made in the previous revolution, extended by `near` along the ring. Every print is compared with
/// every other one.
double share_near_earlier(const std::vector<RolledRow>& rows, std::size_t own, int revolutions);

/// Mean number of tips within `penetration` (m) of their lowest place during one turn of the cone.
double mean_tips_in_contact(const RolledRow& row, double penetration);

}  // namespace tdbd::reference

#pragma once

#include "rock/cut/group_motion.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// What lies farther than this many gaps from the hull around a group touches none of its parts,
/// were a corner of theirs sharp enough to have it between its widened planes (contact_area.hpp).
inline constexpr double gaps_around_hull = 16.0;

/// What of a list is near a group.
struct NearGroup {
  std::vector<int> places;    ///< in the list (of NearList::v) of what the group may sweep
  std::vector<int> touching;  ///< vertices that it may touch at the end of its motion
};

/// Looks through a list, which must cover the motion. Swept may be what keeps_outside does not turn
/// away: which vertices these are does not hang on the list, since where it was made, and when, is
/// a matter of what a run did before. Touched may be all that is nearer than `gap` (m) to the group
/// at the end, if it has not moved by then, and others; nothing if the gap is negative.
void find_candidates(const CuttingGroup& g, const GroupMotion& m,
                     const std::vector<Vec3>& positions_W, const NearList& list, double gap,
                     NearGroup& near);

/// Whether a vertex is outside of the motion's region, or stays on the outer side of one side of
/// the group's box or of one plane of its hull from pose 0 to pose 1.
bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

/// Whether a plane of the group's hull has the point outside by `gap` (m).
bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap);

}  // namespace tdbd::rock

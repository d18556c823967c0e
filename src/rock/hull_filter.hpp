#pragma once

#include "rock/group_motion.hpp"
#include "rock/near_list.hpp"

namespace tdbd::rock {

/// Appends the places in the list (of NearList::v) of those vertices that the group may sweep: all
/// that it does sweep, and those few that no single plane of its hull tells apart. The list must
/// cover the motion.
void find_candidates(const CuttingGroup& g, const GroupMotion& m, const NearList& list,
                     std::vector<int>& places);

/// Appends those vertices of the list that are nearer than `gap` (m) to the group at the end of its
/// motion, and few others.
void find_touching(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap,
                   std::vector<int>& vertices);

/// Whether a plane of the group's hull keeps the vertex outside from pose 0 to pose 1.
bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

}  // namespace tdbd::rock

#pragma once

#include "rock/group_motion.hpp"
#include "rock/near_list.hpp"

namespace tdbd::rock {

/// Appends the places in the list (of NearList::v) of the vertices that keeps_outside does not
/// turn away: among them all that the group sweeps. Which they are does not hang on the list, which
/// must cover the motion: where it was made, and when, is a matter of what a run did before.
void find_candidates(const CuttingGroup& g, const GroupMotion& m,
                     const std::vector<Vec3>& positions_W, const NearList& list,
                     std::vector<int>& places);

/// Appends those vertices of the list that are nearer than `gap` (m) to the group at the end of its
/// motion, and few others.
void find_touching(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap,
                   std::vector<int>& vertices);

/// Whether a vertex is outside of the motion's region, or stays on the outer side of one side of
/// the group's box or of one plane of its hull from pose 0 to pose 1.
bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

/// Whether a plane of the group's hull has the point outside by `gap` (m).
bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap);

}  // namespace tdbd::rock

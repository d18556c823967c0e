#pragma once

#include "rock/cut/group_motion.hpp"
#include "rock/cut/round_sieve.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// A vertex farther than this many gaps from the hull around a group touches none of its parts,
/// even if it lies between the widened planes of a sharp corner (contact_area.hpp).
inline constexpr double gaps_around_hull = 16.0;

/// The vertices of a list that are near a group.
struct NearGroup {
  std::vector<int> places;        ///< indices into NearList::v of what the group may sweep
  std::vector<int> touching;      ///< vertices that it may touch at the end of its motion
  std::vector<SievedPack> packs;  ///< room for the search
};

/// Searches a list, which must cover the motion. The group may sweep what keeps_outside does not
/// reject. The candidate set is independent of the list's history: where and when the list was made
/// does not matter. The group may touch all that is nearer than `gap` (m) to it at the end, if it
/// has not moved by then, and others; nothing if the gap is negative.
void find_candidates(const CuttingGroup& g, const GroupMotion& m, const mesh::Surface& surface,
                     const NearList& list, double gap, NearGroup& near);

/// Whether a vertex is outside the motion's region or stays outside the group from pose 0 to pose 1:
/// outside the cylinder of a round group, or outside one side of the box or one plane of the hull.
bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

/// Whether the point is outside the cylinder of a round group, or outside a plane of the hull of
/// another, by `gap` (m).
bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap);

}  // namespace tdbd::rock

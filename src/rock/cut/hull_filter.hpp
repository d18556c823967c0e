#pragma once

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/sieves.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// A vertex farther than this many gaps from the hull of a group touches none of its parts, not
/// even between the widened planes at a sharp corner (contact_area.hpp).
inline constexpr double gaps_around_hull = 16.0;

/// The vertices of a list that are near a group.
struct NearGroup {
  std::vector<int> places;        ///< indices into NearList::v: the group may sweep these
  std::vector<int> touching;      ///< vertices that the group may touch at the end of its motion
  std::vector<SievedPack> packs;  ///< buffer of the search
};

/// Searches a list, which must cover the motion. The group may sweep every vertex that
/// keeps_outside does not reject; this set does not depend on when and where the list was made.
/// `touching` contains at least all vertices that are closer than `gap` (m) to the group at the end
/// of the step, unless they move before; it is empty if the gap is negative.
void find_candidates(const CuttingGroup& g, const GroupMotion& m, const mesh::Surface& surface,
                     const NearList& list, double gap, NearGroup& near);

/// Whether a vertex is outside the motion's region, or stays outside the group from pose 0 to pose
/// 1: outside the cylinder of a round group, otherwise outside one side of the box or one plane of
/// the hull.
bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

/// Whether the point is outside by more than `gap` (m): outside the cylinder of a round group, or
/// outside a plane of the hull of any other group.
bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap);

}  // namespace tdbd::rock

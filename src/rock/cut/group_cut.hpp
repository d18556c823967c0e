#pragma once

#include <cstdint>
#include <vector>

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/sieves.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/index/near_list.hpp"
#include "rock/rock.hpp"

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

/// Returns the update direction of a group at a rock vertex x: a unit vector in W, rock (8).
/// Thesis: 4.1.2.3, 4.1.3.2.
///   Ur = Rz(azimuth of x in frame D at pose 1) U,   D: see GroupMotion
/// For a group with a core, U is the outward normal, at x's place halfway through the step, of the
/// surfaces of equal distance from the core. It is taken in the half-plane through D's axis and x
/// and clamped to outward and down, rock (9) (reconstructed):
///   n = q - nearest point of the core to q,  q = (q0 + q1)/2,  U ~ (max(n_r, 0), max(n_z, 0))
/// If both components vanish (above the core and on its inner side), U is the group's fixed
/// direction.
Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W);

/// Bit masks of the parts of a group that cannot sweep a candidate. `all_passes`: a vertex that has
/// left a convex part is clear of it permanently, because no level of the strip beyond the exit
/// meets the part again. `this_pass`: a vertex that was only found outside a part may still be moved into
/// it by the group's next part.
struct Excluded {
  std::uint64_t this_pass = 0, all_passes = 0;
};

/// A vertex that a part of the group sweeps, and the place at which it leaves that part.
struct SweptVertex {
  std::size_t which;  ///< index into CuttingGroup::parts
  int v;
  Vec3 x_W;  ///< m
};

/// A move of a vertex by a part of the bit, as the part sees it: the displacement of y in rock
/// (22).
struct VertexMove {
  int v = 0, part = 0;
  Vec3 d_W = Vec3::Zero();  ///< m
};

/// The work of one group in a step, with its buffers. Groups share no data, so they are planned in
/// parallel.
struct GroupCut {
  NearGroup near;                        ///< at the beginning of the step
  bool touching_is_complete = false;     ///< whether near.touching is complete
  std::vector<int> candidates;           ///< of the current pass
  std::vector<Excluded> clear;           ///< per candidate
  std::vector<SweptVertex> swept;        ///< by part, then vertex; a vertex may leave several parts
  std::vector<int> moved, not_excluded;  ///< vertices, in the current pass
  std::vector<int> moved_in_step;        ///< vertices moved in all passes
  std::vector<VertexMove> moves;         ///< in all passes; sorted by vertex at the end of the step
  mesh::Box moved_box_W;                 ///< around the moved vertices at the end of the step
  VertexChanges moved_places;            ///< places of the moved vertices at the end of the step
  std::vector<Vec3> directions_W;        ///< per candidate
  std::vector<RelativePath> paths;       ///< per candidate
  std::vector<Vec3> places_W;            ///< m, per candidate, as planned so far
  std::vector<Vec3>
      left_W;  ///< m, per candidate: ResidualVertex::left_W; only for groups that leave rock
  std::vector<std::size_t> candidates_to_plan,
      alone;  ///< indices of candidates; those planned singly
  SweptScratch exits;
};

/// Finds the vertices among the candidates that the group sweeps, part after part, and their exits.
/// Reads the rock without changing it.
void plan_moves(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut);

/// Plans the candidates with indices in cut.candidates_to_plan and appends their moves to cut.swept.
void plan_candidates(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut);

/// Plans the candidates again that another group has moved since. The path of a vertex depends on
/// that vertex alone, so the plans of the others remain valid.
template <class HasChanged>
void replan_moved(const Rock& rock, const CuttingGroup& g, const GroupMotion& m,
                  HasChanged&& has_changed, GroupCut& cut) {
  cut.candidates_to_plan.clear();
  for (std::size_t i = 0; i < cut.candidates.size(); ++i)
    if (has_changed(cut.candidates[i])) cut.candidates_to_plan.push_back(i);
  if (cut.candidates_to_plan.empty()) return;
  std::erase_if(cut.swept, [&](const SweptVertex& s) { return has_changed(s.v); });
  plan_candidates(rock, g, m, cut);
}

}  // namespace tdbd::rock

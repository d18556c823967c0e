#pragma once

#include <cstdint>
#include <vector>

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/hull_filter.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

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

#pragma once

#include <cstdint>
#include <vector>

#include "rock/cut/hull_filter.hpp"
#include "rock/cut/swept_whole.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Which parts of a group a candidate is clear of, as bits. A vertex that has left a convex part is
/// clear of it for good: beyond the exit no level of the strip meets it again. A vertex merely
/// found outside a part may be moved into it by the group's next part.
struct Clear {
  std::uint64_t now = 0, for_good = 0;
};

/// A vertex that a part of the group sweeps, and where it leaves that part.
struct SweptVertex {
  std::size_t which;  ///< index into CuttingGroup::parts
  int v;
  Vec3 x_W;  ///< m
};

/// A move of a vertex by a part of the bit, as the part sees it: of y in rock (22).
struct VertexMove {
  int v = 0, part = 0;
  Vec3 d_W = Vec3::Zero();  ///< m
};

/// One group's share of a step, with its buffers. Groups share nothing, so they are planned in
/// parallel.
struct GroupCut {
  NearGroup near;                   ///< at the beginning of the step
  bool knows_touching = false;      ///< near.touching is complete
  std::vector<int> candidates;      ///< of the pass
  std::vector<Clear> clear;         ///< per candidate
  std::vector<SweptVertex> swept;   ///< by part, then by vertex; a vertex may leave several parts
  std::vector<int> moved, unclear;  ///< vertices, by the pass
  std::vector<int> moved_in_step;   ///< in all passes
  std::vector<VertexMove> moves;    ///< in all passes; at the end sorted by vertex
  mesh::Box moved_box_W;            ///< around them at the end of the step
  VertexChanges moved_places;       ///< of them at the end of the step
  std::vector<Vec3> directions_W;   ///< per candidate
  std::vector<RelativePath> paths;  ///< per candidate
  std::vector<Vec3> places_W;       ///< m, per candidate, as planned so far
  std::vector<Vec3>
      left_W;  ///< m, per candidate: how much nearer the vertex is; of groups that leave rock
  std::vector<std::size_t> at_work, alone;  ///< candidates; of these, what goes alone
  SweptScratch exits;
};

/// Finds what the group sweeps of its candidates, part after part, and where each vertex leaves.
/// Reads the rock and moves nothing.
void plan_moves(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut);

/// Plans the candidates in cut.at_work (indices) and adds what they do to cut.swept.
void plan_at_work(const Rock& rock, const CuttingGroup& g, const GroupMotion& m, GroupCut& cut);

/// Plans anew the candidates that another group has moved since. A vertex's path depends on that
/// vertex alone, so the others keep theirs.
template <class HasChanged>
void plan_again(const Rock& rock, const CuttingGroup& g, const GroupMotion& m,
                HasChanged&& has_changed, GroupCut& cut) {
  cut.at_work.clear();
  for (std::size_t i = 0; i < cut.candidates.size(); ++i)
    if (has_changed(cut.candidates[i])) cut.at_work.push_back(i);
  if (cut.at_work.empty()) return;
  std::erase_if(cut.swept, [&](const SweptVertex& s) { return has_changed(s.v); });
  plan_at_work(rock, g, m, cut);
}

}  // namespace tdbd::rock

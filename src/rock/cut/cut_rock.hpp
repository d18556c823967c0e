#pragma once

#include <vector>

#include "mesh/surface.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/group_cut.hpp"
#include "rock/index/box_columns.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Returns the volume, m3, by which the hole grows when vertex v of a surface, not on its boundary,
/// moves by d. Positive against the normal (rock removed), rock (10). Around a closed ring it is
/// linear in d, so it is exact for a vertex that moves alone. The sum over vertices moved one after
/// another is the exact change. Thesis: 4.3 (prisms; twin: reference/rock/prism).
inline double star_volume(const mesh::Surface& s, int v, const Vec3& d) {
  const mesh::VertexStar& star = s.star(v);
  const int* ring = s.ring(star);
  const Vec3 first = s.position(ring[0]) - star.x;
  Vec3 doubled_area = Vec3::Zero(), e = first;
  for (int i = 1; i < star.size; ++i) {
    const Vec3 next = s.position(ring[i]) - star.x;
    doubled_area += e.cross(next);
    e = next;
  }
  doubled_area += e.cross(first);
  return -doubled_area.dot(d) / 6.0;
}

/// @file
/// Parts that remove a share of the rock in their way and leave the rest [+] (thesis: rates of
/// removal by area). For a vertex of the surface, the pass of a group begins when the group sweeps
/// the vertex. It ends when neither the vertex nor a neighbour in the same pass is inside a part of
/// the group any more. (Neighbours count because maintenance creates vertices between one inside
/// and one ahead of the part.) During the pass the group sees the vertex at
///   y = x + left,  where it would be if the group removed all,                           rock (22)
/// and a part with the share s that moves y by d moves x by s d, so left grows by (1 - s) d. After
/// the pass x has moved s times the way of y, whatever the step size was. Rock::left is part of the
/// rock's state. Where two groups are in the same rock, each removes its share of it, together at
/// most all.

/// Offset of the place at which a group sees vertex v; zero if it sees the vertex where it is.
Vec3 residue_of(const Rock& rock, const CuttingGroup& g, int v);

/// Records that a part of the group moved v by d_W. Other groups in the same rock see v at the same
/// place as before, or at its new place if that is beyond.
void record_residue(Rock& rock, const CuttingGroup& g, const CuttingPart& part, int v,
                    const Vec3& d_W);

/// Buffers of update_passes.
struct PassScratch {
  std::vector<int> group_of_part, parts;
  std::vector<std::uint8_t> is_inside, goes_on;  ///< per vertex of Rock::left
};

/// Updates Rock::left at the beginning of a step: applies the operations of maintenance since the
/// last cut, and ends the passes that are over. `motions`: per group of the bit. Clears
/// Rock::carried if nothing else needs it.
void update_passes(Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                   PassScratch& work);

/// Assigns Rock::left to the groups of a bit that was prepared again with more cutting parts.
void reassign_residues(Rock& rock, const CuttingBit& bit);

/// Moves the vertices of Rock::left to where their group sees them, on the surface alone, and
/// stores their original places in `places_W`. undo_residues undoes it.
void apply_residues(Rock& rock, std::vector<Vec3>& places_W);
void undo_residues(Rock& rock, const std::vector<Vec3>& places_W);

/// Result of one step. Thesis: 4.1, fig. 4.2 (one iteration of its loop, without maintenance).
struct CutReport {
  std::vector<double> removed_by_part;  ///< m3, per part of the bit
  /// m3, the share of removed_by_part that broke out (section/breakout.hpp); empty: none did
  std::vector<double> broken_out_by_part;
  double removed = 0.0;  ///< m3
  long candidates = 0;   ///< vertices tested
  long moved = 0;        ///< moves made
  int passes = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(removed_by_part, removed, candidates, moved, passes);
  }
};

/// Buffers of a step. They are kept between steps to avoid allocations.
struct CutWorkspace {
  /// Bound on the passes of a step. A vertex between overlapping parts zigzags into their corner;
  /// each pass is shorter than the last by a constant factor. The worst of 120 000 random scenes
  /// took 71 passes.
  int most_passes = 1000;
  NearListMargins list_margins;
  double contact_gap = -1.0;  ///< m, for contact_areas after the step; negative: not measured
  std::vector<GroupMotion> motions;  ///< per group
  std::vector<GroupCut> groups;      ///< per group
  BoxColumns motion_boxes;           ///< per group
  BoxColumns moved_boxes;            ///< per group: GroupCut::moved_box_W
  long changes_before = 0;           ///< changes of the index before the step
  PassScratch passes;                ///< buffers of update_passes
};

/// Updates the rock after the bit moved from pose 0 to pose 1. For each part: find the swept
/// vertices (4.1.1), compute update directions (4.1.3.2), move the vertices (4.1.3), measure the
/// volume (4.3). Passes over all groups repeat until no vertex moves. Afterwards no rock vertex, as
/// a part sees it (rock (22)), lies inside a cutting part at pose 1 by more than tolerance::inside:
/// the contract of rock (5). Throws RunError with the parts' names and a place if the passes do not
/// end or if the bit sweeps the rock's boundary.
void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report);

/// Prepares the workspace for a bit at rest at X_WB. contact_areas requires this before the first
/// step.
void begin_at_rest(const CuttingBit& bit, const Pose& X_WB, CutWorkspace& work);

}  // namespace tdbd::rock

#pragma once

#include <cstdint>
#include <vector>

#include "rock/cut/hull_filter.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// What one step took. Thesis: 4.1, fig. 4.2 (one turn of its loop without maintenance).
struct CutReport {
  std::vector<double> removed_by_part;  ///< m3, per part of the bit
  double removed = 0.0;                 ///< m3
  long candidates = 0;                  ///< vertices tested
  long moved = 0;                       ///< moves made
  int passes = 0;
};

/// Which parts of a group a candidate is clear of, as bits. A vertex that has left a convex part is
/// clear of it for good: beyond the exit no level of the strip meets it again. A vertex merely
/// found outside a part may be moved into it by the group's next part.
struct Clear {
  std::uint64_t now = 0, for_good = 0;
};

/// A vertex and where it was before the part at work moved it, m.
struct MovedVertex {
  int v;
  Vec3 from_W;
};

/// Buffers of a step, kept between steps so that none allocates once warm.
struct CutWorkspace {
  /// A vertex between overlapping parts zigzags into their corner, each pass a constant factor
  /// shorter than the last; the worst of 120 000 random scenes took 71 passes.
  int most_passes = 1000;
  SweptScratch swept;
  std::vector<GroupMotion> motions;          ///< per group
  std::vector<std::vector<int>> candidates;  ///< per group
  std::vector<NearGroup> near;               ///< per group, at the beginning of the step
  std::vector<std::uint8_t> knows_touching;  ///< per group: NearGroup::touching is complete
  std::vector<std::vector<int>> moved_by_group, unclear_by_group;
  std::vector<std::vector<int>> moved_in_step;  ///< per group, in all passes
  std::vector<mesh::Box> moved_boxes_W;         ///< around them at the end of the step
  NearListMargins list_margins;
  double contact_gap = -1.0;  ///< m, of contact_areas after the step; negative: contact disabled
  std::vector<MovedVertex> moves;  ///< by the part at work
  std::vector<int> move_of;        ///< per vertex: its index in `moves`, if it is there
  std::vector<int> triangles;
  std::vector<Vec3> directions_W;
  std::vector<RelativePath> paths;  ///< of the candidates of the group at work
  std::vector<Clear> clear;         ///< per candidate of the group at work
  std::vector<int> step_of_move;    ///< per vertex: the last step that moved it
  long changes_before = 0;          ///< of the index, when the step began
  int step = 0;                     ///< number of the last step
};

/// One update of the rock after the bit moved from pose 0 to pose 1: find (4.1.1), map (4.1.3.2),
/// move (4.1.3), measure (4.3), part after part; passes repeat until nothing moves. Afterwards no
/// rock vertex lies inside a cutting part at pose 1 (tolerance::inside): the contract of rock (5).
/// Throws RunError with the parts' names and a place if passes do not end or the bit sweeps the
/// rock's boundary.
void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report);

}  // namespace tdbd::rock

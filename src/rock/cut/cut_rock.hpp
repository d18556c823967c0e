#pragma once

#include <vector>

#include "rock/cut/group_cut.hpp"
#include "rock/cut/left_rock.hpp"
#include "rock/index/box_columns.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

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
  PassWork passes;                   ///< buffers of begin_passes
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

#pragma once

#include <vector>

#include "rock/cut/group_cut.hpp"
#include "rock/cut/left_rock.hpp"
#include "rock/index/box_columns.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// What one step took. Thesis: 4.1, fig. 4.2 (one turn of its loop without maintenance).
struct CutReport {
  std::vector<double> removed_by_part;  ///< m3, per part of the bit
  /// m3, of removed_by_part: what broke out (section/breakout.hpp); empty: nothing did.
  std::vector<double> broken_out_by_part;
  double removed = 0.0;  ///< m3
  long candidates = 0;   ///< vertices tested
  long moved = 0;        ///< moves made
  int passes = 0;
};

/// Buffers of a step, kept between steps so that none allocates once warm.
struct CutWorkspace {
  /// A vertex between overlapping parts zigzags into their corner, each pass a constant factor
  /// shorter than the last; the worst of 120 000 random scenes took 71 passes.
  int most_passes = 1000;
  NearListMargins list_margins;
  double contact_gap = -1.0;  ///< m, of contact_areas after the step; negative: contact disabled
  std::vector<GroupMotion> motions;  ///< per group
  std::vector<GroupCut> groups;      ///< per group
  BoxColumns motion_boxes;           ///< per group
  BoxColumns moved_boxes;            ///< per group: GroupCut::moved_box_W
  long changes_before = 0;           ///< of the index, when the step began
  PassWork passes;                   ///< begin_passes
};

/// One update of the rock after the bit moved from pose 0 to pose 1: find (4.1.1), map (4.1.3.2),
/// move (4.1.3), measure (4.3), part after part; passes repeat until nothing moves. Afterwards no
/// rock vertex, as a part sees it (rock (22)), lies inside a cutting part at pose 1
/// (tolerance::inside): the contract of rock (5).
/// Throws RunError with the parts' names and a place if passes do not end or the bit sweeps the
/// rock's boundary.
void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report);

/// Prepares the workspace of a bit at rest at X_WB, as contact_areas requires it before any step.
void begin_at_rest(const CuttingBit& bit, const Pose& X_WB, CutWorkspace& work);

}  // namespace tdbd::rock

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
  long candidates = 0;                  ///< vertices looked at
  long moved = 0;                       ///< moves made
  int passes = 0;
};

/// Which parts of a group a candidate is clear of, as bits. A convex part that let go of a vertex
/// does so for good: beyond its exit no level of the strip meets it again. What was merely found
/// outside of a part may be moved into it by the group's next part.
struct Clear {
  std::uint64_t now = 0, for_good = 0;
};

/// A vertex and where it was before the part at work moved it, m.
struct MovedVertex {
  int v;
  Vec3 from_W;
};

/// Room for the step, kept between steps so that none allocates once warm.
struct CutWorkspace {
  /// A vertex between overlapping parts zigzags into their corner, each pass shorter than the last
  /// by a factor; the worst of 120 000 random scenes took 71 passes.
  int most_passes = 1000;
  SweptScratch swept;
  std::vector<GroupMotion> motions;          ///< per group
  std::vector<std::vector<int>> candidates;  ///< per group
  std::vector<NearGroup> near;               ///< per group, of the step's beginning
  std::vector<std::uint8_t> knows_touching;  ///< per group: NearGroup::touching is all there is
  std::vector<std::vector<int>> moved_by_group, unclear_by_group;
  std::vector<std::vector<int>> moved_in_step;  ///< per group, in all passes
  std::vector<mesh::Box> moved_boxes_W;         ///< around these, where they are at the step's end
  Foresight foresight;
  double contact_gap = -1.0;       ///< m, of contact_areas after the step; negative: nobody asks
  std::vector<MovedVertex> moves;  ///< by the part at work
  std::vector<int> move_of;        ///< per vertex: its place in `moves`, if that is its place
  std::vector<int> triangles;
  std::vector<Vec3> directions_W;
  std::vector<RelativePath> paths;  ///< of the candidates of the group at work
  std::vector<Clear> clear;         ///< per candidate of the group at work
  std::vector<int> step_of_move;    ///< per vertex: the last step that moved it
  long changes_before = 0;          ///< of the index, when the step began
  int step = 0;                     ///< that the workspace did last
};

/// One update of the rock after the bit moved from pose 0 to pose 1: find (4.1.1), map (4.1.3.2),
/// move (4.1.3), measure (4.3), part after part; passes repeat until nothing moves. Afterwards no
/// rock vertex lies inside a cutting part at pose 1 (tolerance::inside). Throws RunError with the
/// parts' names and a place if passes do not end or the bit sweeps the rock's boundary.
void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report);

}  // namespace tdbd::rock

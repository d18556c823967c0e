#pragma once

#include "rock/cut/cutting_bit.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Poses of one group during a step, and quantities derived from them.
struct GroupMotion {
  Pose X_PW0, X_PW1;
  /// Frame D of the update directions at pose 1: the bit's frame or, if the bit leans and
  /// directions are upright, the axes of space at the bit's origin. Its rotation about z does not
  /// matter.
  Pose X_DW1;
  Mat3 R_WD1, R_DB;
  double reach_W;   ///< m, largest distance from the z axis of space that the group can sweep
  Region region_W;  ///< motion box: the group's box at pose 0 and pose 1, axis-aligned and oriented
  Pose X_WP0, X_WP1;
};

/// Thesis: 4.1.1.
GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1);

/// Whether the group stays nearer to the hole's axis than any rock at its heights.
inline bool is_out_of_reach(const VertexGrid& grid, const GroupMotion& m) {
  return grid.nearest_to_axis(m.region_W.box.lo.z(), m.region_W.box.hi.z()) > m.reach_W;
}

}  // namespace tdbd::rock

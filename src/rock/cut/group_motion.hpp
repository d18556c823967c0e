#pragma once

#include "rock/cut/cutting_bit.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// Poses of one group during a step, and derived quantities.
struct GroupMotion {
  Pose X_PW0, X_PW1;
  /// Frame D of the update directions at pose 1: the bit's frame or, if directions are upright and
  /// the bit leans, axes parallel to those of W at the bit's origin. Its rotation about z does not
  /// matter.
  Pose X_DW1;
  Mat3 R_WD1, R_DB;
  double reach_W;   ///< m, no point of the group sweeps farther from the z axis of W
  Region region_W;  ///< bounds of the group's box at both poses, axis-aligned and oriented
  Pose X_WP0, X_WP1;
};

/// Computes the motion of a group. Thesis: 4.1.1.
GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1);

/// Whether the whole group stays closer to the hole's axis than all rock at its heights.
inline bool is_out_of_reach(const VertexGrid& grid, const GroupMotion& m) {
  return grid.nearest_to_axis(m.region_W.box.lo.z(), m.region_W.box.hi.z()) > m.reach_W;
}

}  // namespace tdbd::rock

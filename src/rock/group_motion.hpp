#pragma once

#include "rock/cutting_bit.hpp"
#include "rock/swept_convex.hpp"
#include "rock/vertex_grid.hpp"

namespace tdbd::rock {

/// Poses of one group during a step, and what follows from them.
struct GroupMotion {
  Pose X_PW0, X_PW1;
  /// Frame D of the update directions at pose 1: the bit's or, where that leans and directions are
  /// upright, the axes of space at the bit's origin. How D is turned about z does not matter.
  Pose X_DW1;
  Mat3 R_WD1, R_DB;
  double reach_W;   ///< m, farthest from the z axis of space that the group can sweep
  Region region_W;  ///< motion box: the group's box at pose 0 and pose 1, axis-aligned and oriented
};

/// Thesis: 4.1.1.
GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1);

/// Appends the rock vertices that the group may sweep: all that it does sweep, and those few that
/// no single plane of its hull tells apart. `chains` is room for the grid's query.
void find_candidates(const VertexGrid& grid, const CuttingGroup& g, const GroupMotion& m,
                     std::vector<int>& chains, std::vector<int>& candidates);

/// Tells, for one group and step, whether a plane of the hull keeps a rock vertex outside from pose
/// 0 to pose 1. Asks first the plane that answered last, in space: neighbours have it in common.
class HullFilter {
 public:
  HullFilter(const CuttingGroup& g, const GroupMotion& m) : hull_P_(g.hull_P), motion_(m) {
    choose(0);
  }
  bool keeps_outside(const Vec3& x_W) { return last_plane_keeps_outside(x_W) || find_plane(x_W); }

  /// Without a branch until the answer.
  bool last_plane_keeps_outside(const Vec3& x_W) const {
    return static_cast<int>(n0_W_.dot(x_W) >= b0_) & static_cast<int>(n1_W_.dot(x_W) >= b1_);
  }

 private:
  void choose(std::size_t plane);
  bool find_plane(const Vec3& x_W);

  const mesh::ConvexSolid& hull_P_;
  const GroupMotion& motion_;
  Vec3 n0_W_, n1_W_;  ///< the plane at pose 0 and at pose 1
  double b0_ = 0.0, b1_ = 0.0;
};

}  // namespace tdbd::rock

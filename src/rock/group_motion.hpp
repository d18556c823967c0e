#pragma once

#include <array>

#include "rock/cutting_bit.hpp"
#include "rock/swept_convex.hpp"
#include "rock/vertex_grid.hpp"

namespace tdbd::rock {

/// Poses of one group during a step, and what follows from them.
struct GroupMotion {
  Pose X_PW0, X_PW1;
  Pose X_BW1;
  Mat3 R_WB1;
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
/// Vertices may come in single precision: nothing nearer to the plane than that rounding is kept
/// outside.
class HullFilter {
 public:
  HullFilter(const CuttingGroup& g, const GroupMotion& m);
  bool keeps_outside(const Vec3& x_W) { return last_plane_keeps_outside(x_W) || find_plane(x_W); }

  /// Appends the block's vertices that no plane keeps outside.
  void add_unclear(const VertexGrid::Block& block, std::vector<int>& candidates);

 private:
  /// n . x - b >= 0 is outside, in columns' precision; at pose 0 and at pose 1.
  struct SpacePlane {
    std::array<Single, 3> n{};
    Single b = 0.0;
  };

  void choose(std::size_t plane);
  bool find_plane(const Vec3& x_W);
  /// Without a branch until the answer.
  bool last_plane_keeps_outside(const Vec3& x_W) const {
    return static_cast<int>(n0_W_.dot(x_W) >= b0_) & static_cast<int>(n1_W_.dot(x_W) >= b1_);
  }
  /// Bit s stands for the block's vertex s.
  static unsigned outside_of(const VertexGrid::Block& block,
                             const std::array<SpacePlane, 2>& plane_W);

  const mesh::ConvexSolid& hull_P_;
  const GroupMotion& motion_;
  double slack_;      ///< m
  Vec3 n0_W_, n1_W_;  ///< the plane at pose 0 and at pose 1, moved out by the slack
  double b0_ = 0.0, b1_ = 0.0;
  std::array<SpacePlane, 2> plane_W_{};
};

}  // namespace tdbd::rock

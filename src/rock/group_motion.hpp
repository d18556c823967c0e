#pragma once

#include <array>

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
/// 0 to pose 1. Asks first the two planes that answered last, in space: neighbours have them in
/// common, and a cutter's face and back take turns.
/// Vertices may come in single precision: nothing nearer to the plane than that rounding is kept
/// outside.
class HullFilter {
 public:
  HullFilter(const CuttingGroup& g, const GroupMotion& m);
  bool keeps_outside(const Vec3& x_W) { return find_plane(x_W); }

  /// Appends the block's vertices that no plane keeps outside.
  void add_unclear(const VertexGrid::Block& block, std::vector<int>& candidates);

 private:
  /// A plane of the hull in space at pose 0 and at pose 1, single: n . x >= b is outside.
  struct SpacePlane {
    std::array<Single, 3> n0{}, n1{};
    Single b0 = 0.0, b1 = 0.0;
  };

  SpacePlane in_space(std::size_t plane) const;
  bool find_plane(const Vec3& x_W);
  /// Bit s stands for the block's vertex s.
  static unsigned outside_of(const VertexGrid::Block& block, const SpacePlane& plane);

  const mesh::ConvexSolid& hull_P_;
  const GroupMotion& motion_;
  double slack_;              ///< m
  SpacePlane last_, before_;  ///< that answered
};

}  // namespace tdbd::rock

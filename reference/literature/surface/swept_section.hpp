#pragma once

#include "reference/literature/surface/spoke_plane.hpp"
#include "reference/literature/surface/sweep_tool.hpp"

namespace tdbd::reference {

/// A convex body over one step: its edges at the step's start and end, and the straight paths of
/// its corners. In the bit's frame at the step's end.
struct SweptBody {
  int cutter = -1;                        ///< index into Bit::cutters
  std::vector<Vec3> corners_B;            ///< at the end, then at the start
  std::vector<std::array<int, 2>> edges;  ///< of corners
  Vec3 middle_B = Vec3::Zero();
  double reach = 0.0;  ///< m, from the middle to the farthest corner
};

/// X_B1B0: the body's frame at the step's start relative to that at its end.
SweptBody swept_body(const mesh::TriangleMesh& convex_B, const Pose& X_B1B0);

/// One body per cutter.
std::vector<SweptBody> swept_bodies(const std::vector<CutterHull>& cutters, const Pose& X_B1B0);

/// The outline of the swept body in the plane of a spoke and beyond the axis: the convex hull of
/// all places where its edges cross the plane. Exact for a step without rotation, because the hull
/// of two shifted copies has no other edges. Otherwise it lies within the hull of both, with an
/// error of second order in the rotation. Empty if the plane misses the body. `corners_W`: the
/// body's corners in space.
Outline section(const SweptBody& body, const std::vector<Vec3>& corners_W, const SpokePlane& plane);

}  // namespace tdbd::reference

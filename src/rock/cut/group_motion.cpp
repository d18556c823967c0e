#include "rock/cut/group_motion.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::rock {
namespace {

/// Bounds of the box at both poses: axis-aligned planes, and planes normal to the box's own axes at
/// pose 1.
Region moving_box(const mesh::Box& box_P, const Pose& X_WP0, const Pose& X_WP1) {
  const Vec3 middle_P = 0.5 * (box_P.lo + box_P.hi), half = 0.5 * box_P.size();
  const Vec3 c0_W = X_WP0 * middle_P, c1_W = X_WP1 * middle_P;
  const Vec3 half0_W = X_WP0.R.cwiseAbs() * half, half1_W = X_WP1.R.cwiseAbs() * half;
  Region r;
  r.box = {(c0_W - half0_W).cwiseMin(c1_W - half1_W), (c0_W + half0_W).cwiseMax(c1_W + half1_W)};
  const Mat3 R_P1W = X_WP1.R.transpose();
  const Vec3 half0 = (R_P1W * X_WP0.R).cwiseAbs() * half, c0 = R_P1W * c0_W, c1 = R_P1W * c1_W;
  for (int i = 0; i < 3; ++i)
    r.slabs[at(i)] = {X_WP1.R.col(i), std::min(c0[i] - half0[i], c1[i] - half[i]),
                      std::max(c0[i] + half0[i], c1[i] + half[i])};
  return r;
}

/// Upper bound of the distance from the hole's axis. The chord of a rotation is nearer to the axis
/// than its ends by the cosine of half the angle. A tilted axis shifts a point by at most the tilt
/// times its distance from the origin; this is counted for the part and for the rock beside it.
double reach(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const double cosine = 0.5 * ((X_WB0.R.transpose() * X_WB1.R).trace() - 1.0);
  const double half_turn = std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine)));
  double off_axis = 0.0;
  for (const Pose* X_WB : {&X_WB0, &X_WB1}) {
    const double tilt = (X_WB->R.col(2) - Vec3::UnitZ()).norm();
    off_axis = std::max(off_axis, X_WB->p.head<2>().norm() + 4.0 * tilt * g.distance);
  }
  return half_turn > 0.5 ? g.reach / half_turn + off_axis : INFINITY;
}

Pose direction_frame(const CuttingGroup& g, const Pose& X_WB) {
  const bool leans = X_WB.R.col(2) != Vec3::UnitZ();
  return leans && g.directions == DirectionFrame::upright ? Pose{Mat3::Identity(), X_WB.p} : X_WB;
}

}  // namespace

GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const Pose X_WP0 = X_WB0 * g.X_BP, X_WP1 = X_WB1 * g.X_BP1, X_WD1 = direction_frame(g, X_WB1);
  const bool is_bit = X_WD1.R == X_WB1.R;
  return {inverse(X_WP0),
          inverse(X_WP1),
          inverse(X_WD1),
          X_WD1.R,
          is_bit ? Mat3(Mat3::Identity()) : Mat3(X_WD1.R.transpose() * X_WB1.R),
          reach(g, X_WB0, X_WB1),
          moving_box(g.box_P, X_WP0, X_WP1),
          X_WP0,
          X_WP1};
}

}  // namespace tdbd::rock

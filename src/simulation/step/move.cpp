#include "simulation/step/move.hpp"

#include <utility>

#include "rotation/screw.hpp"

namespace tdbd::simulation {

BitVelocity velocity_of(const Move& move, std::vector<double> cone_speeds) {
  const rotation::Twist twist = rotation::twist_from(move.X_WB0, move.X_WB1, move.dt);
  const Mat3& R_WB = move.X_WB1.R;
  return {move.X_WB1.p, R_WB * twist.linear_B, R_WB * twist.angular_B, std::move(cone_speeds)};
}

Vec3 velocity_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& m, int cone,
                 const Vec3& x_W) {
  Vec3 v_W = m.v_W + m.w_W.cross(x_W - m.p_WB);
  if (cone < 0) return v_W;
  const Pose X_WK = X_WB * bit.cones[at(cone)].X_BK;
  return v_W + m.cone_speeds[at(cone)] * X_WK.R.col(2).cross(x_W - X_WK.p);
}

}  // namespace tdbd::simulation

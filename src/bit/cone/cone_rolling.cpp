#include "bit/cone/cone_rolling.hpp"

#include <algorithm>

#include "bit/cone/cone_measures.hpp"

namespace tdbd::bit {

SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts) {
  const Vec3 s_B = X_BK.R.col(2);
  SlipBalance sum;
  for (const ConeContact& c : contacts) {
    const Vec3 r_B = c.x_B - X_BK.p;
    sum.moment += c.weight * s_B.dot(r_B.cross(rotation::velocity_B(bit, c.x_B)));
    sum.inertia += c.weight * s_B.cross(r_B).squaredNorm();
  }
  return sum;
}

Vec3 tooth_tip_P(const Part& tooth) {
  double height = 0.0;
  for (const Vec3& x_P : tooth.mesh_P.positions) height = std::max(height, x_P.z());
  return {0.0, 0.0, height};
}

double rolling_ratio_of_gage_row(const Cone& cone) {
  RowMeasures outermost;
  bool found_gage = false;
  for (const ToothRow& row : cone.layout.rows) {
    const bool at_gage = row.place == RowPlace::gage;
    const RowMeasures m = row_measures(cone, row);
    if (at_gage < found_gage) continue;
    if (at_gage > found_gage || m.bit_radius > outermost.bit_radius) outermost = m;
    found_gage = found_gage || at_gage;
  }
  return outermost.rolling_ratio;
}

}  // namespace tdbd::bit

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
  if (cone.layout.rows.empty()) return cone.rolling_ratio;
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

double rolling_ratio_of_parts(const Cone& cone, int index, const std::vector<Part>& parts) {
  const auto turns = [&](const Part& p) { return p.cone == index && p.cutting == Cutting::cuts; };
  const bool has_teeth = std::ranges::any_of(
      parts, [&](const Part& p) { return turns(p) && p.kind == PartKind::tooth; });
  double farthest = 0.0, ratio = 0.0;
  for (const Part& part : parts) {
    if (!turns(part) || (has_teeth && part.kind != PartKind::tooth)) continue;
    double radius = 0.0, z_K = 0.0;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_K = inverse(cone.X_BK) * (part.X_BP * x_P);
      if (x_K.head<2>().norm() <= radius) continue;
      radius = x_K.head<2>().norm();
      z_K = x_K.z();
    }
    const double bit_radius = deepest_B(cone, radius, z_K).head<2>().norm();
    if (radius == 0.0 || bit_radius <= farthest) continue;
    farthest = bit_radius;
    ratio = bit_radius / radius;
  }
  return ratio;
}

}  // namespace tdbd::bit

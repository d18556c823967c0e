#include "simulation/step/part_drag.hpp"

#include <algorithm>

namespace tdbd::simulation {
namespace {

/// Slope of a law by differences of a millionth of the speed: well above rounding, and small
/// compared with the curvature.
Mat3 slope(const forces::Law& law, const CutOfPart& cut, const Vec3& v, double dt, const Vec3& F) {
  constexpr double over_speed = 1e-6;
  const double dv = over_speed * v.norm();
  Mat3 D;
  for (int j = 0; j < 3; ++j) {
    const forces::PartCut moved = cut_at_velocity(v + dv * Vec3::Unit(j), dt, cut);
    D.col(j) = (F - forces::force(law, moved).force) / dv;
  }
  return D;
}

}  // namespace

Mat3 secant_resistance(const Vec3& v, const Vec3& F) {
  const double v2 = v.squaredNorm(), along = F.dot(v) / v2;
  const Vec3 q = -(F - along * v) / v2;
  return -along * Mat3::Identity() + q * v.transpose() - v * q.transpose();
}

PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which) {
  const Vec3 v = v_W.norm() > smallest_speed ? v_W : Vec3(smallest_speed * cut.cut.normal);
  const forces::Law& law = law_of(plan, cut);
  PartDrag drag;
  drag.force = forces::force(law, cut_at_velocity(v, dt, cut));
  if (which == Resistance::secant) drag.resistance = secant_resistance(v, drag.force.force);
  if (which == Resistance::tangent) drag.resistance = slope(law, cut, v, dt, drag.force.force);
  return drag;
}

}  // namespace tdbd::simulation

#include "forces/part/pressing.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::forces {
namespace {

/// Share of the limit that acts at the speeds v_n (m/s, into the rock) and |v_t|.
double pressed_share(double into, double along, double ramp) {
  constexpr double rounding = 1e-12;
  const double full = ramp * along;
  if (full > 0.0) return std::clamp(into / full, 0.0, 1.0);
  return into >= -rounding * along && into + along > 0.0 ? 1.0 : 0.0;
}

}  // namespace

Vec3 slip_velocity(const Vec3& velocity, const Vec3& normal) {
  constexpr double rounding = 1e-14;
  Vec3 slip = velocity - velocity.dot(normal) * normal;
  if (slip.norm() <= rounding * velocity.norm()) return Vec3::Zero();
  slip -= slip.dot(normal) * normal;  // the first difference may leave some of it
  return slip;
}

PartForce pressing_force(const PartCut& cut, const Pressing& pressing) {
  const Vec3 slip = slip_velocity(cut.velocity, cut.normal);
  const double along = slip.norm();
  const double normal =
      pressing.limit * pressed_share(cut.velocity.dot(cut.normal), along, pressing.ramp);
  const double drag =
      slip_share(along, pressing.slip_speed) * friction_at(pressing.sliding, along) * normal;
  PartForce f{
      .force = -normal * cut.normal, .point = cut.point, .normal = normal, .tangential = drag};
  if (along > 0.0) f.force -= drag / along * slip;
  return f;
}

}  // namespace tdbd::forces

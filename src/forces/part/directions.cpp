#include "forces/part/directions.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::forces {
namespace {

/// Sine of the angle to a plunge below which e2 shrinks.
constexpr double plunge = 0.5;

}  // namespace

double effective_back_rake(const Vec3& face_normal, const Vec3& velocity) {
  const double speed = velocity.norm();
  return speed > 0.0 ? std::acos(std::clamp(face_normal.dot(velocity) / speed, 0.0, 1.0)) : 0.0;
}

CutFrame cut_frame(const Vec3& velocity, const Vec3& normal) {
  const double speed = velocity.norm();
  if (speed == 0.0) return {.e1 = Vec3::Zero(), .e2 = normal};
  CutFrame frame{.e1 = velocity / speed, .e2 = Vec3::Zero()};
  const double a = frame.e1.dot(normal);
  const Vec3 across = normal - a * frame.e1;
  frame.e2 = across / std::max(across.norm(), plunge);
  if (a < 0.0) frame.e1 -= a * normal;
  return frame;
}

double slip_share(double speed, double slip_speed) {
  return speed == 0.0 ? 0.0 : speed / std::hypot(speed, slip_speed);
}

double friction_at(const Sliding& sliding, double speed) {
  if (sliding.weakening == 0.0) return sliding.mu;
  const double lost = -std::expm1(-speed / sliding.weakening_speed);
  return sliding.mu * (1.0 - sliding.weakening * lost);
}

PartForce cutting_force(const PartCut& cut, double Ft, double Fn, double slip_speed) {
  const CutFrame frame = cut_frame(cut.velocity, cut.normal);
  const double share = slip_share(cut.velocity.norm(), slip_speed);
  return {.force = -share * (Ft * frame.e1 + Fn * frame.e2),
          .point = cut.point,
          .normal = share * Fn,
          .tangential = share * Ft};
}

namespace {

/// Share of the limit that acts at the speeds v_n (m/s, into the rock) and |v_t|.
double normal_force_share(double into, double along, double ramp) {
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
      pressing.limit * normal_force_share(cut.velocity.dot(cut.normal), along, pressing.ramp);
  const double drag =
      slip_share(along, pressing.slip_speed) * friction_at(pressing.sliding, along) * normal;
  PartForce f{
      .force = -normal * cut.normal, .point = cut.point, .normal = normal, .tangential = drag};
  if (along > 0.0) f.force -= drag / along * slip;
  return f;
}

}  // namespace tdbd::forces

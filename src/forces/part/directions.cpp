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

}  // namespace tdbd::forces

#include "bit/update_direction.hpp"

#include <cmath>

#include "core/error.hpp"

namespace tdbd::bit {
namespace {

/// U~ of eq. 4.1: the cutter's -Z, rotated to azimuth 0 and projected on the X-Z plane.
Vec3 preliminary_direction(const Pose& X_BC) {
  const double r = std::hypot(X_BC.p.x(), X_BC.p.y());
  const double cos_azimuth = r > 0.0 ? X_BC.p.x() / r : 1.0;
  const double sin_azimuth = r > 0.0 ? X_BC.p.y() / r : 0.0;
  const Vec3 minus_z_B = -X_BC.R.col(2);
  return {cos_azimuth * minus_z_B.x() + sin_azimuth * minus_z_B.y(), 0.0, minus_z_B.z()};
}

Vec3 inside_direction(InsideRule rule) {
  switch (rule) {
    case InsideRule::plus_x:
      return Vec3::UnitX();
    case InsideRule::minus_x:
      return -Vec3::UnitX();
    case InsideRule::down:
      break;
  }
  return Vec3::UnitZ();
}

}  // namespace

Vec3 update_direction(const Pose& X_BC, DirectionRule rule, InsideRule inside) {
  return update_direction(preliminary_direction(X_BC), rule, inside);
}

Vec3 update_direction(const Vec3& u, DirectionRule rule, InsideRule inside) {
  if (rule == DirectionRule::all_down) return Vec3::UnitZ();
  if (rule == DirectionRule::hybrid && u.x() <= 0.0) return inside_direction(inside);
  if (u.norm() == 0.0)
    throw InputError("cutter: found a -Z axis that points sideways, expected one along (r, z)");
  return u.normalized();
}

}  // namespace tdbd::bit

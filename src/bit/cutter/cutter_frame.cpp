#include "bit/cutter/cutter_frame.hpp"

#include <cmath>

namespace tdbd::bit {
namespace {

Vec3 radial_B(const Cutter& c) { return {std::cos(c.azimuth), std::sin(c.azimuth), 0.0}; }

}  // namespace

Vec3 direction_of_motion_B(const Cutter& c) {
  return {-std::sin(c.azimuth), std::cos(c.azimuth), 0.0};
}

double land_depth(const Cutter& c) { return c.land > 0.0 ? c.land / std::tan(c.land_angle) : 0.0; }

double chamfer_depth(const Cutter& c) {
  return c.chamfer / std::tan(c.chamfer_angle) + land_depth(c);
}

Vec3 tip_C(const Cutter& c) {
  return {c.chamfer > 0.0 ? -chamfer_depth(c) : 0.0, 0.0, -0.5 * c.diameter};
}

Vec3 tip_B(const Cutter& c) { return c.tip_radius * radial_B(c) - c.tip_height * Vec3::UnitZ(); }

Vec3 profile_normal_B(const Cutter& c) {
  return std::sin(c.profile_angle) * radial_B(c) + std::cos(c.profile_angle) * Vec3::UnitZ();
}

Pose cutter_pose(const Cutter& c) {
  const Vec3 t = direction_of_motion_B(c), n = profile_normal_B(c);
  const double cb = std::cos(c.back_rake), sb = std::sin(c.back_rake);
  const double cs = std::cos(c.side_rake), ss = std::sin(c.side_rake);
  const Vec3 x = cb * t + sb * n, z = sb * t - cb * n, y = z.cross(x);
  Pose X_BC;
  X_BC.R.col(0) = cs * x + ss * y;
  X_BC.R.col(1) = cs * y - ss * x;
  X_BC.R.col(2) = z;
  X_BC.p = tip_B(c) - X_BC.R * tip_C(c);
  return X_BC;
}

}  // namespace tdbd::bit

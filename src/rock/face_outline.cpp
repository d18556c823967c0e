#include "rock/face_outline.hpp"

#include <cmath>
#include <numbers>

#include "bit/cutter_frame.hpp"

namespace tdbd::rock {

FaceOutline face_outline(const bit::Cutter& c, int rim_points) {
  const Vec3 tip_C = bit::tip_C(c);
  FaceOutline face{c.X_BC * Pose{Mat3::Identity(), Vec3(tip_C.x(), 0.0, 0.0)}, {}};
  face.rim_F.reserve(static_cast<std::size_t>(rim_points));
  for (int k = 0; k < rim_points; ++k) {
    const double a = 2.0 * std::numbers::pi * k / rim_points;
    face.rim_F.emplace_back(-tip_C.z() * std::sin(a), tip_C.z() * std::cos(a));
  }
  if (c.wear <= 0.0) return face;
  const Vec3 n_F = face.X_BF.R.transpose() * bit::profile_normal_B(c);
  ConvexPolygon left;
  clip(face.rim_F, {n_F.tail<2>(), tip_C.z() * n_F.z() - c.wear}, left);
  face.rim_F = left;
  return face;
}

}  // namespace tdbd::rock

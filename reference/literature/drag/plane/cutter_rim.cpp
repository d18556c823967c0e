#include "reference/literature/drag/plane/cutter_rim.hpp"

namespace tdbd::reference {

CutterRim cutter_rim(const bit::Cutter& c, double side_rake) {
  const Vec3 radial(std::cos(c.azimuth), std::sin(c.azimuth), 0.0);
  const Vec3 t(-radial.y(), radial.x(), 0.0);
  const Vec3 n = std::sin(c.profile_angle) * radial + std::cos(c.profile_angle) * Vec3::UnitZ();
  const Vec3 up = std::sin(c.back_rake) * t - std::cos(c.back_rake) * n;
  const Vec3 ahead = std::cos(c.back_rake) * t + std::sin(c.back_rake) * n;
  const Vec3 across = up.cross(ahead);
  const double a = c.diameter / 2.0, cosine = std::cos(side_rake), sine = std::sin(side_rake);
  CutterRim rim;
  rim.tip_B = c.tip_radius * radial - c.tip_height * Vec3::UnitZ();
  rim.centre_B = rim.tip_B + a * up;
  rim.down_B = -a * up;
  rim.side_B = a * (cosine * across - sine * ahead);
  rim.motion_B = t;
  rim.face_B = cosine * ahead + sine * across;
  rim.normal_B = n;
  rim.wear = c.wear;
  return rim;
}

RimEllipse rim_ellipse(const CutterRim& rim, const Vec3& radial_B) {
  const double p = radial_B.dot(rim.down_B), q = radial_B.dot(rim.side_B);
  const double u = rim.down_B.z(), w = rim.side_B.z(), square = p * p + q * q;
  RimEllipse e;
  e.x0 = radial_B.dot(rim.centre_B);
  e.z0 = rim.centre_B.z();
  e.half_width = std::sqrt(square);
  e.slope = (u * p + w * q) / square;
  e.bulge = std::abs(w * p - u * q) / e.half_width;
  e.is_worn = rim.wear > 0.0;
  e.normal_x = radial_B.dot(rim.normal_B);
  e.normal_z = rim.normal_B.z();
  e.flat = e.normal_x * radial_B.dot(rim.tip_B) + e.normal_z * rim.tip_B.z() - rim.wear;
  return e;
}

}  // namespace tdbd::reference

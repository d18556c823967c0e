#include "rotation/rotation_vector.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace tdbd::rotation {

Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Mat3 exp(const Vec3& v) {
  const double angle2 = v.squaredNorm();
  const Mat3 S = skew(v);
  if (angle2 < 1e-8)  // next terms: angle^4 / 120 and / 720, below rounding
    return Mat3::Identity() + (1.0 - angle2 / 6.0) * S + (0.5 - angle2 / 24.0) * S * S;
  const double angle = std::sqrt(angle2);
  const double half = std::sin(0.5 * angle);
  return Mat3::Identity() + (std::sin(angle) / angle) * S + (2.0 * half * half / angle2) * S * S;
}

Vec3 log(const Mat3& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double s = q.vec().norm();
  if (s == 0.0) return Vec3::Zero();
  return (2.0 * std::atan2(s, q.w()) / s) * q.vec();
}

}  // namespace tdbd::rotation

#include "rotation/screw.hpp"

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

Pose carried(const Twist& twist, double s) {
  const Vec3 turn = s * twist.angular_B;
  const double x = turn.squaredNorm(), angle = std::sqrt(x), half = 0.5 * angle;
  double c1 = 1.0 - x / 6.0, c2 = 0.5 - x / 24.0, c3 = 1.0 / 6.0 - x / 120.0;
  constexpr double series_end = 1e-7;  // next terms: x^2 / 120, / 720, / 5040, below rounding
  if (x > series_end) {
    c1 = std::sin(angle) / angle;
    c2 = 2.0 * std::sin(half) * std::sin(half) / x;
    c3 = (1.0 - c1) / x;
  }
  const Mat3 S = skew(turn), S2 = S * S;
  return {Mat3::Identity() + c1 * S + c2 * S2,
          s * (twist.linear_B + c2 * (S * twist.linear_B) + c3 * (S2 * twist.linear_B))};
}

Twist twist_from(const Pose& X_WB0, const Pose& X_WB1, double dt) {
  const Mat3 R = X_WB0.R.transpose() * X_WB1.R, odd = 0.5 * (R - R.transpose());
  const Vec3 sine(odd(2, 1), odd(0, 2), odd(1, 0)), p_B = X_WB0.R.transpose() * (X_WB1.p - X_WB0.p);
  const double s = sine.norm(), angle = std::atan2(s, 0.5 * (R.trace() - 1.0)), x = angle * angle;
  constexpr double series_end = 1e-3;  // next term: angle^4 / 30240, below rounding
  const double c =
      angle > series_end ? (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / x : 1.0 / 12.0 + x / 720.0;
  const Vec3 turn = s > 0.0 ? Vec3(angle / s * sine) : Vec3::Zero();
  const Mat3 S = skew(turn);
  return {turn / dt, (p_B - 0.5 * (S * p_B) + c * (S * (S * p_B))) / dt};
}

}  // namespace tdbd::rotation

#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tdbd::rotation {

/// @file
/// R = Swing Twist, rotation (6): the twist rotates about the z axis of space, the swing tilts z to
/// R z.
///
/// The twist angle counts full turns. A quaternion followed in small steps gives it modulo 4 pi;
/// `turns` is the number of completed double turns.

/// Twist angle about z, rad: 2 atan2(q_z, q_w) + 4 pi turns.
template <class S>
S twist_angle(const Eigen::Quaternion<S>& q, long turns) {
  using std::atan2;
  return 2.0 * atan2(q.z(), q.w()) + 4.0 * std::numbers::pi * static_cast<double>(turns);
}

/// The change of `turns` if q moves from one attitude to the next by less than half a turn.
template <class S>
long turns_passed(const Eigen::Quaternion<S>& from, const Eigen::Quaternion<S>& to) {
  const bool was_below = from.z() < S(0), is_below = to.z() < S(0);
  if (was_below == is_below || !(from.w() + to.w() < S(0))) return 0;
  return is_below ? 1 : -1;
}

/// Gradient of the twist angle with respect to rotations in space: d(twist) = gradient . w_W dt.
/// Undefined if z is upside down.
template <class S>
Eigen::Matrix<S, 3, 1> twist_gradient(const Eigen::Quaternion<S>& q) {
  const S n = 1.0 / (q.w() * q.w() + q.z() * q.z());
  return {n * (q.w() * q.y() + q.z() * q.x()), n * (q.z() * q.y() - q.w() * q.x()), S(1)};
}

/// The swing as a rotation vector b in the plane z = 0, b = angle z x d / |z x d| with d = R z, and
/// the dependence of its length on d_z: b = f (z x d), f = angle / sin(angle), slope = df/d(d_z).
template <class S>
struct Swing {
  Eigen::Matrix<S, 3, 1> d, b;
  S f, slope;
};

template <class S>
Swing<S> swing(const Eigen::Quaternion<S>& q) {
  using std::atan2;
  using std::sqrt;
  Swing<S> s;
  s.d = q * Eigen::Matrix<S, 3, 1>(S(0), S(0), S(1));
  const S sine2 = s.d[0] * s.d[0] + s.d[1] * s.d[1];
  constexpr double small = 1e-6;  // sin^2; the series' next terms are 1e-13 of the first
  if (sine2 < small && s.d[2] > S(0)) {
    s.f = 1.0 + sine2 * (1.0 / 6.0 + sine2 * (3.0 / 40.0));
    s.slope = -1.0 / 3.0 - sine2 * (2.0 / 15.0);
  } else {
    const S sine = sqrt(sine2);
    s.f = atan2(sine, s.d[2]) / sine;
    s.slope = -(1.0 - s.f * s.d[2]) / sine2;
  }
  s.b = {-s.f * s.d[1], s.f * s.d[0], S(0)};
  return s;
}

}  // namespace tdbd::rotation

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace tdbd::rotation {

/// @file
/// Stumpff functions, rotation (3): c_k(x) = sum_j (-x)^j / (2j + k)! of x = t^2:
///   c_0 = cos t, c_1 = sin t / t, c_2 = (1 - cos t) / t^2, c_3 = (t - sin t) / t^3, ...
/// They are regular at zero and work for doubles and for scalar types with derivatives. Up to x =
/// 1/4 they are evaluated as polynomials, without calls to the mathematical library of the machine.

inline constexpr double stumpff_series_end = 0.25;  ///< x; below it 8 terms are exact to rounding

/// x; below it 5 terms and their derivative are exact to rounding.
inline constexpr double stumpff_short_series_end = 1.0 / 1024.0;

/// (-1)^j / (2j + k)! for j = 0..7.
template <int k>
constexpr std::array<double, 8> stumpff_coefficients() {
  std::array<double, 8> a{};
  double factorial = 1.0;
  for (int n = 2; n <= k; ++n) factorial *= n;
  for (int j = 0; j < 8; ++j) {
    a[static_cast<std::size_t>(j)] = (j % 2 == 0 ? 1.0 : -1.0) / factorial;
    factorial *= (2.0 * j + k + 1) * (2.0 * j + k + 2);
  }
  return a;
}

/// c_k(x) for 0 <= x <= stumpff_series_end, summed in pairs to shorten dependency chains.
template <int k, class S>
S stumpff_series(const S& x) {
  constexpr std::array<double, 8> a = stumpff_coefficients<k>();
  const S x2 = x * x;
  const S low = (a[0] + a[1] * x) + (a[2] + a[3] * x) * x2;
  if (x <= stumpff_short_series_end) return low + a[4] * (x2 * x2);
  const S high = (a[4] + a[5] * x) + (a[6] + a[7] * x) * x2;
  return low + high * (x2 * x2);
}

template <class S>
struct CosSinc {
  S cos, sinc;
};

/// cos t and sin t / t of x = t^2.
template <class S>
CosSinc<S> cos_sinc(const S& x) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  if (x <= stumpff_series_end) return {stumpff_series<0, S>(x), stumpff_series<1, S>(x)};
  const S t = sqrt(x);
  return {cos(t), sin(t) / t};
}

/// c_0 to c_5. Derivatives by x: c_1' = (c_3 - c_2)/2, c_2' = c_4 - c_3/2, c_3' = (3 c_5 - c_4)/2.
template <class S>
struct Stumpff {
  S c0, c1, c2, c3, c4, c5;
};

template <class S>
Stumpff<S> stumpff(const S& x) {
  if (x <= stumpff_series_end) {
    const S c4 = stumpff_series<4, S>(x), c5 = stumpff_series<5, S>(x);
    const S c2 = 0.5 - x * c4, c3 = 1.0 / 6.0 - x * c5;
    return {1.0 - x * c2, 1.0 - x * c3, c2, c3, c4, c5};
  }
  const CosSinc<S> t = cos_sinc(x);
  const S c2 = (1.0 - t.cos) / x, c3 = (1.0 - t.sinc) / x;
  return {t.cos, t.sinc, c2, c3, (0.5 - c2) / x, (1.0 / 6.0 - c3) / x};
}

/// @file
/// Unit quaternions as attitudes. S is double or a scalar type with derivatives.

/// Rotation by |v| (rad) about v; rotation (1).
template <class S>
Eigen::Quaternion<S> quaternion_exp(const Eigen::Matrix<S, 3, 1>& v) {
  const CosSinc<S> half = cos_sinc<S>(0.25 * v.squaredNorm());
  const S f = 0.5 * half.sinc;
  return {half.cos, f * v[0], f * v[1], f * v[2]};
}

/// One Newton step towards unit length: a squared length of 1 + d gives a length of 1 - 3 d^2 / 8.
template <class S>
void renormalise(Eigen::Quaternion<S>& q) {
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

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
long double_turns_between(const Eigen::Quaternion<S>& from, const Eigen::Quaternion<S>& to) {
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

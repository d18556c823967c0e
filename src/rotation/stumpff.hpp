#pragma once

#include <array>
#include <cmath>

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

}  // namespace tdbd::rotation

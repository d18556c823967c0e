#pragma once

#include <Eigen/Core>
#include <cmath>

namespace tdbd::battery {

/// A number that carries its derivatives by N variables, exact to rounding (forward mode). Compares
/// by value, so that a kernel takes the same branches as with plain numbers.
template <int N>
struct Dual {
  using Derivatives = Eigen::Array<double, N, 1>;
  double value = 0.0;
  Derivatives by = Derivatives::Zero();

  Dual() = default;
  Dual(double x) : value(x) {}  // NOLINT: plain numbers mix with these
  Dual(double x, const Derivatives& d) : value(x), by(d) {}

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.by + b.by}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.by - b.by}; }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.by}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.by * b.value + b.by * a.value};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return {q, (a.by - q * b.by) / b.value};
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  friend Dual sqrt(const Dual& a) {
    const double r = std::sqrt(a.value);
    return {r, a.by / (2.0 * r)};
  }
  friend Dual cos(const Dual& a) { return {std::cos(a.value), -std::sin(a.value) * a.by}; }
  friend Dual sin(const Dual& a) { return {std::sin(a.value), std::cos(a.value) * a.by}; }
  friend Dual abs(const Dual& a) { return a.value < 0.0 ? -a : a; }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double r2 = x.value * x.value + y.value * y.value;
    return {std::atan2(y.value, x.value), (x.value * y.by - y.value * x.by) / r2};
  }
};

/// Enough for the canonical coordinates of a gyrostat with three cones.
using Jet = Dual<12>;

}  // namespace tdbd::battery

namespace Eigen {

template <int N>
struct NumTraits<tdbd::battery::Dual<N>> : NumTraits<double> {
  using Real = tdbd::battery::Dual<N>;
  using NonInteger = Real;
  using Nested = Real;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1 };
};

template <int N, class Operation>
struct ScalarBinaryOpTraits<tdbd::battery::Dual<N>, double, Operation> {
  using ReturnType = tdbd::battery::Dual<N>;
};
template <int N, class Operation>
struct ScalarBinaryOpTraits<double, tdbd::battery::Dual<N>, Operation> {
  using ReturnType = tdbd::battery::Dual<N>;
};

}  // namespace Eigen

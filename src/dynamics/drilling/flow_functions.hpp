#pragma once

#include <array>
#include <cmath>

namespace tdbd::dynamics {

/// Functions of z = c time that appear in the solution of u' = f - c u over a time (dynamics (20)).
struct FlowFunctions {
  double decay = 1.0;      ///< exp(-z)
  double mean = 1.0;       ///< (1 - exp(-z))/z: mean of the decay over the time
  double second = 0.5;     ///< (1 - mean)/z
  double third = 1.0 / 6;  ///< (1/2 - second)/z
};

inline FlowFunctions flow_functions(double z) {
  FlowFunctions f;
  if (std::abs(z) > 1.0) {
    f.decay = std::exp(-z);
    f.mean = -std::expm1(-z) / z;
    f.second = (1.0 - f.mean) / z;
    f.third = (0.5 - f.second) / z;
    return f;
  }
  constexpr int terms = 18;  // of the series of `third`, sum of (-z)^j / (j + 3)!
  f.third = 1.0;
  for (int j = terms; j > 0; --j) f.third = 1.0 - z / (j + 3) * f.third;
  f.third /= 6.0;
  f.second = 0.5 - z * f.third;
  f.mean = 1.0 - z * f.second;
  f.decay = 1.0 - z * f.mean;
  return f;
}

/// Mean of f over [0, 1] by the five-point Gauss rule.
template <class F>
double gauss_mean(const F& f) {
  constexpr std::array<double, 2> off{0.269234655052841545, 0.453089922969331996};
  constexpr std::array<double, 2> weight{0.239314335249683234, 0.118463442528094544};
  double sum = 64.0 / 225.0 * f(0.5);
  for (std::size_t i = 0; i < off.size(); ++i)
    sum += weight[i] * (f(0.5 - off[i]) + f(0.5 + off[i]));
  return sum;
}

}  // namespace tdbd::dynamics

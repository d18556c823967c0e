#pragma once

#include <cmath>
#include <optional>

namespace tdbd::reference {

/// A zero of a continuous function between two places where its signs differ, by regula falsi in the
/// manner of Illinois: the value of an end that stays is halved. Stops where the bracket or the last
/// move is below `tolerance`. None if the signs do not differ.
template <typename Function>
std::optional<double> bracketed_root(const Function& f, double low, double high, double tolerance) {
  constexpr int most = 100;
  double at_low = f(low), at_high = f(high);
  if (at_low == 0.0) return low;
  if (at_high == 0.0) return high;
  if ((at_low > 0.0) == (at_high > 0.0)) return std::nullopt;
  double x = low;
  for (int i = 0, kept = 0; i < most; ++i) {
    const double next = (low * at_high - high * at_low) / (at_high - at_low);
    const bool still = std::abs(next - x) < tolerance;
    x = next;
    if (still || high - low < tolerance) break;
    const double value = f(x);
    if (value == 0.0) break;
    if ((value > 0.0) == (at_high > 0.0)) {
      high = x, at_high = value;
      if (kept == -1) at_low *= 0.5;
      kept = -1;
    } else {
      low = x, at_low = value;
      if (kept == 1) at_high *= 0.5;
      kept = 1;
    }
  }
  return x;
}

}  // namespace tdbd::reference

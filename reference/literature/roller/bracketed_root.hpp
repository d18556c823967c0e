#pragma once

#include <algorithm>
#include <optional>

namespace tdbd::reference {

/// A zero of a continuous function between two places where its signs differ, by regula falsi in the
/// manner of Illinois: the value of an end that stays is halved. Half a tolerance is kept from both ends,
/// so that the bracket closes from both sides; it ends narrower than `tolerance`. None if the signs do
/// not differ.
template <typename Function>
std::optional<double> bracketed_root(const Function& f, double low, double high, double tolerance) {
  constexpr int most = 200;
  double at_low = f(low), at_high = f(high);
  if (at_low == 0.0) return low;
  if (at_high == 0.0) return high;
  if ((at_low > 0.0) == (at_high > 0.0)) return std::nullopt;
  enum class End { none, lower, upper } moved = End::none;
  for (int i = 0; i < most && high - low > tolerance; ++i) {
    const double guess = (low * at_high - high * at_low) / (at_high - at_low);
    const double x = std::clamp(guess, low + 0.5 * tolerance, high - 0.5 * tolerance);
    const double value = f(x);
    if (value == 0.0) return x;
    if ((value > 0.0) == (at_high > 0.0)) {
      high = x, at_high = value;
      if (moved == End::upper) at_low *= 0.5;
      moved = End::upper;
    } else {
      low = x, at_low = value;
      if (moved == End::lower) at_high *= 0.5;
      moved = End::lower;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace tdbd::reference

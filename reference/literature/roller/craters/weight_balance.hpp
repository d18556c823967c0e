#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tdbd::reference {

/// How the bracket is narrowed: by bisection, or by interpolation, truncation and projection
/// (Oliveira and Takahashi 2021), which never needs more than one step more than bisection.
enum class BalanceSearch { bisection, itp };

struct BalanceOptions {
  double reach = 5e-3;      ///< m, half width of the first bracket, about the bit's previous place
  double tolerance = 1e-9;  ///< m, of the place
  int most_doublings = 10;  ///< of the reach: up to 5 m
  BalanceSearch search = BalanceSearch::itp;
};

/// The equilibrium of the bit.
struct WeightBalance {
  double z = 0.0;       ///< m, down
  int evaluations = 0;  ///< of the weight
  int narrowings = 0;   ///< steps of the search after the place was bracketed
};

/// An interval that contains the place, and the excess over the weight at its ends, N: negative at
/// `low`.
struct WeightBracket {
  double low = 0.0, high = 0.0;    ///< m
  double under = 0.0, over = 0.0;  ///< N, at `low` and at `high`
};

/// Throws InputError: "MODEL: no root for z: ...".
[[noreturn]] void throw_no_balance(std::string_view model, const WeightBracket& tried,
                                   double reached, double weight);

/// The next place to evaluate, by interpolation, truncation and projection: within `room` of the
/// middle, so that at most one step more than bisection is needed.
double next_place(const WeightBracket& in, double first_width, double room);

/// The last part of the search for z. `weight_at` (N) must not decrease with z.
template <typename WeightAt>
WeightBalance narrow_balance(WeightAt&& weight_at, WeightBracket in, double weight,
                             const BalanceOptions& options) {
  WeightBalance found;
  const double width = in.high - in.low, tolerance = options.tolerance;
  const int most = static_cast<int>(std::ceil(std::log2(std::max(width / tolerance, 1.0))));
  for (; in.high - in.low > tolerance; ++found.narrowings) {
    const double half = 0.5 * (in.high - in.low);
    const double room = 0.5 * tolerance * std::ldexp(1.0, most + 1 - found.narrowings) - half;
    const double z = options.search == BalanceSearch::itp ? next_place(in, width, room)
                                                          : 0.5 * (in.low + in.high);
    const double beyond = weight_at(z) - weight;
    (beyond < 0.0 ? in.low : in.high) = z;
    (beyond < 0.0 ? in.under : in.over) = beyond;
    if (beyond == 0.0) in.low = z;
  }
  found.evaluations = found.narrowings;
  found.z = 0.5 * (in.low + in.high);
  return found;
}

/// Ma, Zhou and Deng: the place z at which the teeth carry `weight` (N, positive), by iteration
/// from the bit's previous place. The bracket is doubled until it contains the place. The bit may
/// also move up, when it rides on a ridge. Our reconstruction of "an iteration process" (thesis
/// 2.2).
template <typename WeightAt>
WeightBalance weight_balance(WeightAt&& weight_at, double z_before, double weight,
                             const BalanceOptions& options, std::string_view model) {
  const double here = weight_at(z_before) - weight;
  WeightBracket in{z_before, z_before, here, here};
  int evaluations = 1;
  double reach = options.reach;
  for (; in.under >= 0.0 || in.over < 0.0; reach *= 2.0, ++evaluations) {
    const bool deeper = here < 0.0;
    if (evaluations > options.most_doublings + 1)
      throw_no_balance(model, in, (deeper ? in.over : in.under) + weight, weight);
    const double end = z_before + (deeper ? reach : -reach);
    in = deeper ? WeightBracket{in.high, end, in.over, weight_at(end) - weight}
                : WeightBracket{end, in.low, weight_at(end) - weight, in.under};
  }
  WeightBalance found = narrow_balance(weight_at, in, weight, options);
  found.evaluations += evaluations;
  return found;
}

}  // namespace tdbd::reference

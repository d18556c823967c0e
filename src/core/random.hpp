#pragma once

#include <cstdint>

namespace tdbd {

/// SplitMix64 generator (Steele, Lea and Flood, 2014). The same seed gives the same numbers on
/// every machine and with every standard library; std::uniform_real_distribution does not guarantee
/// that.
struct Random {
  std::uint64_t state = 0;  ///< the seed at first

  std::uint64_t next() {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in [lo, hi].
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
};

}  // namespace tdbd

#pragma once

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace tdbd::calibration {

/// A standard normal random number by the Box-Muller method; the second number of each pair is
/// discarded.
inline double normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * random.uniform());
}

}  // namespace tdbd::calibration

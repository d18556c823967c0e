#pragma once

#include "rock/maintain/limits.hpp"

namespace tdbd::rock {

/// Limits without flips, smoothing and steps at rest, so that a test adds those that it tests.
inline MaintenanceLimits bare_limits_for(double edge_length) {
  return limits_for(
      edge_length,
      {.rest = 0, .flip_quality = 0.0, .smoothing = Smoothing::off, .smooth_quality = 0.0});
}

}  // namespace tdbd::rock

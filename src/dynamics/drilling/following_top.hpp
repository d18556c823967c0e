#pragma once

#include "dynamics/drilling/configuration.hpp"

/// A loaded top that follows the bit: TopDrive::following_time, dynamics (12a).
namespace tdbd::dynamics {

/// Rate of the upper end of the string's dampers, m/s along +z.
double rate_of_damper_end(const DrillingSystem& system, const DrillingState& state);

/// Relaxes the top's rate towards the attachment's velocity over `time` (s), exactly while that
/// stands still. Without effect where the top does not follow the bit.
void follow_bit(const DrillingSystem& system, const Configuration& at, double time,
                DrillingState& state);

}  // namespace tdbd::dynamics

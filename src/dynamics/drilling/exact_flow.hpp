#pragma once

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// @file
/// What resists motion in one direction, integrated exactly while everything else stands still,
/// dynamics (14): it never adds energy, whatever the time. An impulse j along the direction changes
/// the momenta by j times it and the speed along it by j times its mobility.

/// A direction of bit, one cone or rock: the force and the torque that act for a unit of impulse.
struct Direction {
  Vec3 force_W = Vec3::Zero();
  Vec3 torque_W = Vec3::Zero();  ///< about the centre of mass
  int cone = -1;                 ///< about this cone's axis, between bit and cone
  double rock = 0.0;             ///< on the rock, along +z
};

/// Speed along the direction, m/s or rad/s, and how much an impulse changes it.
struct Along {
  double speed = 0.0;
  double mobility = 0.0;  ///< 1/kg or 1/(kg m2)
};
Along along(const DrillingSystem& system, const Configuration& at, const DrillingState& state,
            const Direction& direction);

void give_impulse(const Direction& direction, double impulse, DrillingState& state);

/// Impulse of a damper over a time: the speed against its other end falls as
/// exp(-coefficient mobility time).
double damper_impulse(const Along& a, double coefficient, double other_end_speed, double time);

/// Rate of the upper end of the string's dampers, m/s along +z: that of a loaded top that follows the
/// bit (TopDrive::following_time), the top's own, or 0 where they end in space.
double rate_of_damper_end(const DrillingSystem& system, const DrillingState& state);

/// Relaxes the rate of a loaded top that follows the bit towards the attachment's velocity over
/// `time` (s), exactly while that stands still, dynamics (12a). Without effect on other tops.
void follow_bit(const DrillingSystem& system, const Configuration& at, double time,
                DrillingState& state);

/// Kinetic energy that an impulse adds, J.
inline double energy_of_impulse(const Along& a, double impulse) {
  return impulse * (a.speed + 0.5 * impulse * a.mobility);
}

}  // namespace tdbd::dynamics

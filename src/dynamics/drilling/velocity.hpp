#pragma once

#include <span>

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// Velocities of a state with known configuration. Allocates nothing after the first call.
void velocity(const DrillingSystem& system, const Configuration& at, const DrillingState& state,
              DrillingVelocity& out);

/// Velocities of any state. Computes the configuration.
DrillingVelocity velocity(const DrillingSystem& system, const DrillingState& state);

/// Velocity in W of a point of the bit, m/s. `arm_W` is the vector from the centre of mass to it,
/// m.
inline Vec3 point_velocity(const DrillingVelocity& v, const Vec3& arm_W) {
  return v.v_W + v.w_W.cross(arm_W);
}

/// Creates the state at time 0 from the pose of the bit's frame, velocities, and cone angles (rad).
DrillingState make_drilling_state(const DrillingSystem& system, const Pose& X_WB,
                                  const DrillingVelocity& v, std::span<const double> cone_angles);

/// Slack position of the string such that it carries the weight of the bit in this state, so that
/// the bit is in equilibrium. Directions without stiffness are unchanged.
Vec3 hanging_rest_W(const DrillingSystem& system, const DrillingState& state);

/// Power of a wrench at a velocity, W. `cone_share` scales the torques on the cones' own spins.
double power_on_bit(const Wrench& wrench, const DrillingVelocity& v, double cone_share = 1.0);
double power_on_rock(const Wrench& wrench, const DrillingVelocity& v);

}  // namespace tdbd::dynamics

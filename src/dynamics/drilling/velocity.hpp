#pragma once

#include <span>

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// Velocities of a state whose configuration is at hand. No allocation once warm.
void velocity(const DrillingSystem& system, const Configuration& at, const DrillingState& state,
              DrillingVelocity& out);

/// The same for any state, whose configuration it computes.
DrillingVelocity velocity(const DrillingSystem& system, const DrillingState& state);

/// Velocity in W of a point of the bit, m/s; `arm_W` from the centre of mass to it, m.
inline Vec3 point_velocity(const DrillingVelocity& v, const Vec3& arm_W) {
  return v.v_W + v.w_W.cross(arm_W);
}

/// The state at time 0 with the bit's frame at X_WB, these velocities, and cones at these angles
/// (rad).
DrillingState make_drilling_state(const DrillingSystem& system, const Pose& X_WB,
                                  const DrillingVelocity& v, std::span<const double> cone_angles);

/// The string's rest at which it carries the bit's weight in this state, so that the bit hangs
/// still. Directions in which it has no stiffness stay as slack as they are.
Vec3 hanging_rest_W(const DrillingSystem& system, const DrillingState& state);

/// Power of a wrench at a velocity, W; `cone_share` scales the torques on the cones' own spins.
double power_on_bit(const Wrench& wrench, const DrillingVelocity& v, double cone_share = 1.0);
double power_on_rock(const Wrench& wrench, const DrillingVelocity& v);

}  // namespace tdbd::dynamics

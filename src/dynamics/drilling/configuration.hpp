#pragma once

#include <span>

#include "core/types.hpp"
#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::dynamics {

/// Upper end of the string at one instant.
struct TopPosition {
  Vec3 point_W = Vec3::Zero();  ///< position of the attachment with a slack string, m
  double angle = 0.0;           ///< rad, unwrapped
};

/// Forces of the string on the bit, and the energy stored in it.
struct StringPull {
  Vec3 arm_W = Vec3::Zero();     ///< from the centre of mass to the attachment, m
  Vec3 spring_W = Vec3::Zero();  ///< N, of the translational springs
  double load = 0.0;             ///< N along +z, of the top if it is loaded
  double twist_moment = 0.0;     ///< N m, of the top on the upper end of the string
  Vec3 turn_W = Vec3::Zero();    ///< N m, of the rotational springs
  double energy = 0.0;           ///< J
};

/// Contact between ring and wall. Depth 0 means no contact.
struct WallContact {
  double depth = 0.0;               ///< penetration of the ring, m
  Vec3 outward_W = Vec3::UnitX();   ///< from the axis of the wall to the contact point
  Vec3 tangent_W = Vec3::UnitY();   ///< along the circumference, about +z
  Vec3 ring_arm_W = Vec3::Zero();   ///< from the centre of mass to the centre of the ring, m
  Vec3 touch_arm_W = Vec3::Zero();  ///< from the centre of mass to the contact point, m
};

/// Quantities that depend only on time and positions, such as conservative forces and inverse
/// inertia. Computed once per step.
struct Configuration {
  Mat3 R_WB = Mat3::Identity();
  Mat3 mobility_W = Mat3::Identity();  ///< R It^-1 R^T, 1/(kg m2)
  TopPosition top;
  StringPull pull;
  WallContact contact;
  Wrench conservative;        ///< string, load, gravity, wall and rock mount
  double chain_energy = 0.0;  ///< J, of a chain without its last element; valid if no step is open
};

TopPosition top_position(const DrillingSystem& system, const DrillingState& state);

/// Penalty stiffness of the wall: its force is the mean of the forces during loading and unloading.
double mean_wall_stiffness(const Wall& wall);

/// Computes a configuration. Allocates nothing.
void configure(const DrillingSystem& system, const DrillingState& state, Configuration& out);

/// Energies of the springs, J.
double wall_energy(const DrillingSystem& system, const Configuration& at);
double rock_energy(const DrillingSystem& system, const DrillingState& state);

/// Pose of the bit's frame in space.
Pose bit_pose(const DrillingSystem& system, const DrillingState& state);

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

#pragma once

#include "core/pose.hpp"
#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::dynamics {

/// The string's upper end at one instant.
struct TopPosition {
  Vec3 point_W = Vec3::Zero();  ///< where the slack string would hold the bit, m
  double angle = 0.0;           ///< rad, windings count
};

/// What the string pulls with, and what is stored in it.
struct StringPull {
  Vec3 arm_W = Vec3::Zero();     ///< from the centre of mass to the attachment, m
  Vec3 spring_W = Vec3::Zero();  ///< N, of the springs of translation
  double load = 0.0;             ///< N along +z, of the top where it is loaded
  double twist_moment = 0.0;     ///< N m, with which the top turns the string's upper end
  Vec3 turn_W = Vec3::Zero();    ///< N m, of the springs of rotation
  double energy = 0.0;           ///< J
};

/// The ring against the wall. Not touching: depth 0.
struct WallContact {
  double depth = 0.0;               ///< how far the ring is pressed in, m
  Vec3 outward_W = Vec3::UnitX();   ///< from the wall's axis to the touching point
  Vec3 tangent_W = Vec3::UnitY();   ///< along the circumference, about +z
  Vec3 ring_arm_W = Vec3::Zero();   ///< from the centre of mass to the ring's centre, m
  Vec3 touch_arm_W = Vec3::Zero();  ///< and to the touching point, m
};

/// Everything that follows from time and positions alone: what the conservative forces are, how
/// readily momenta make velocities. Made once a step.
struct Configuration {
  Mat3 R_WB = Mat3::Identity();
  Mat3 mobility_W = Mat3::Identity();  ///< R It^-1 R^T, 1/(kg m2)
  TopPosition top;
  StringPull pull;
  WallContact contact;
  Wrench conservative;        ///< string, load, gravity, wall and rock mount
  double chain_energy = 0.0;  ///< J, of a chain without its last element; when no step is open
};

TopPosition top_position(const DrillingSystem& system, const DrillingState& state);

/// Penalty of the wall: the stiffness whose force is the mean of pressing and letting go.
double mean_wall_stiffness(const Wall& wall);

/// No allocation.
void configure(const DrillingSystem& system, const DrillingState& state, Configuration& out);

/// Energies of the springs, J.
double wall_energy(const DrillingSystem& system, const Configuration& at);
double rock_energy(const DrillingSystem& system, const DrillingState& state);

/// The bit's frame in space.
Pose bit_pose(const DrillingSystem& system, const DrillingState& state);

}  // namespace tdbd::dynamics

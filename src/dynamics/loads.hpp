#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::dynamics {

/// The frame in which a torque vector is constant: that of the bit, or space.
enum class TorqueFrame { body, space };

/// torque(t) = amplitude cos(angular_frequency t + phase).
struct HarmonicTorque {
  TorqueFrame frame = TorqueFrame::body;
  Vec3 amplitude = Vec3::Zero();   ///< N m
  double angular_frequency = 0.0;  ///< rad/s; 0: constant
  double phase = 0.0;              ///< rad
};

/// A torque given by samples: linear between them, constant before the first and after the last.
struct SampledTorque {
  TorqueFrame frame = TorqueFrame::body;
  std::vector<double> times;  ///< s, ascending
  std::vector<Vec3> torques;  ///< N m
};

/// A torque about the axis of a cone.
struct ConeLoad {
  double internal = 0.0;  ///< N m, from the bit (motor, bearing); the opposite acts on the bit
  double external = 0.0;  ///< N m, from outside (rock); also changes the total momentum
  double damping = 0.0;   ///< N m s/rad, bearing friction: internal torque -damping * phi'
};

/// Torques on a gyrostat. All zero means free motion. Torques are about the centre of mass, or
/// about the fixed point of a top. Frames: W space (z down), B bit.
struct Loads {
  Vec3 body_torque_B = Vec3::Zero();   ///< N m, constant in the bit's frame
  Vec3 space_torque_W = Vec3::Zero();  ///< N m, constant in space
  double gravity_moment = 0.0;         ///< N m: potential V = gravity_moment * ez . R arm_B
  Vec3 gravity_arm_B = Vec3::UnitZ();  ///< unit vector, from the fixed point to the centre of mass
  std::vector<HarmonicTorque> harmonics;
  std::vector<SampledTorque> samples;
  /// Linear springs to space, N m/rad: V = (x swing_x^2 + y swing_y^2 + z twist^2) / 2 with the
  /// swing-twist angles of the attitude about the z axis of space. The twist is unwrapped, so full
  /// turns count.
  Vec3 stiffness_W = Vec3::Zero();
  Vec3 damping_W = Vec3::Zero();  ///< N m s/rad: torque -damping_W * w_W, by component
  std::vector<ConeLoad> cones;    ///< one per cone
};

}  // namespace tdbd::dynamics

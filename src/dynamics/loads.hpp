#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::dynamics {

/// A torque vector that is constant in the bit's frame or in space.
enum class TorqueFrame { body, space };

/// torque(t) = amplitude cos(angular_frequency t + phase).
struct HarmonicTorque {
  TorqueFrame frame = TorqueFrame::body;
  Vec3 amplitude = Vec3::Zero();   ///< N m
  double angular_frequency = 0.0;  ///< rad/s; 0: constant
  double phase = 0.0;              ///< rad
};

/// Samples of a torque, linear between them, held before the first and after the last.
struct SampledTorque {
  TorqueFrame frame = TorqueFrame::body;
  std::vector<double> times;  ///< s, ascending
  std::vector<Vec3> torques;  ///< N m
};

/// A torque about a cone's axis.
struct ConeLoad {
  double internal = 0.0;  ///< N m, from the bit (motor, bearing): the bit feels the opposite
  double external = 0.0;  ///< N m, from outside (rock): changes the total momentum too
  double damping = 0.0;   ///< N m s/rad, bearing friction: internal torque -damping * phi'
};

/// What turns a gyrostat. Everything zero: free. Torques about the centre of mass, or about the
/// fixed point of a top. Frames: W space (z down), B bit.
struct Loads {
  Vec3 body_torque_B = Vec3::Zero();   ///< N m, fixed in the bit
  Vec3 space_torque_W = Vec3::Zero();  ///< N m, fixed in space
  double gravity_moment = 0.0;         ///< N m: potential V = gravity_moment * ez . R arm_B
  Vec3 gravity_arm_B = Vec3::UnitZ();  ///< unit, from the fixed point to the centre of mass
  std::vector<HarmonicTorque> harmonics;
  std::vector<SampledTorque> samples;
  /// Linear springs to space, N m/rad: V = (x swing_x^2 + y swing_y^2 + z twist^2) / 2 with the
  /// swing-twist angles of the attitude about space z; the twist is unwrapped, so windings count.
  Vec3 stiffness_W = Vec3::Zero();
  Vec3 damping_W = Vec3::Zero();  ///< N m s/rad: torque -damping_W * w_W, by component
  std::vector<ConeLoad> cones;    ///< one for each cone
};

}  // namespace tdbd::dynamics

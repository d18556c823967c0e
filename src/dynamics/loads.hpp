#pragma once

#include <vector>

#include "core/types.hpp"
#include "dynamics/gyrostat.hpp"
#include "rotation/quaternion.hpp"

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

/// Torque in space of the moments m_x, m_y on the swing components: if dV/db = m, the gradient of
/// -V with respect to rotations in space.
template <class S>
Vec3Of<S> swing_torque_W(const S& m_x, const S& m_y, const rotation::Swing<S>& w) {
  const S along = w.slope * (m_y * w.d[0] - m_x * w.d[1]);
  const Vec3Of<S> gradient_d(w.f * m_y, -w.f * m_x, along);  // dV/dd
  return gradient_d.cross(w.d);
}

/// Torque of springs to space on the swing-twist angles, dynamics (8): V = (kx b_x^2 + ky b_y^2 +
/// kz twist^2) / 2, stiffness in N m/rad (thesis: eq. 2.3). The torque is the gradient of -V with
/// respect to rotations in space, so energy is conserved.
template <class S>
Vec3Of<S> spring_torque_W(const Vec3Of<double>& stiffness, const RotationStateOf<S>& s) {
  Vec3Of<S> torque = Vec3Of<S>::Zero();
  if (stiffness.z() != 0.0)
    torque -=
        (stiffness.z() * rotation::twist_angle(s.q_WB, s.turns)) * rotation::twist_gradient(s.q_WB);
  if (stiffness.x() == 0.0 && stiffness.y() == 0.0) return torque;
  const rotation::Swing<S> w = rotation::swing(s.q_WB);
  return torque + swing_torque_W<S>(stiffness.x() * w.b[0], stiffness.y() * w.b[1], w);
}

/// Energy stored in the springs, J.
template <class S>
S spring_energy(const Vec3Of<double>& stiffness, const RotationStateOf<S>& s) {
  const Vec3Of<S> b = rotation::swing(s.q_WB).b;
  const S twist = rotation::twist_angle(s.q_WB, s.turns);
  return 0.5 * (stiffness.x() * b[0] * b[0] + stiffness.y() * b[1] * b[1] +
                stiffness.z() * twist * twist);
}

}  // namespace tdbd::dynamics

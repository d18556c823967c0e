#pragma once

#include "dynamics/rotation_state.hpp"
#include "rotation/swing_twist.hpp"

namespace tdbd::dynamics {

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

#pragma once

#include <span>

#include "dynamics/gyrostat.hpp"

namespace tdbd::dynamics {

/// @file
/// The inertia relations, dynamics (2) (thesis: 5.2.1, 5.3):
///   Pi = It W + sum_k pi_k s_k,   pi_k = Ic_k (phi_k' + s_k . W).

/// sigma_B = sum_k pi_k s_k: momentum of the cones, N m s.
template <class S>
Vec3Of<S> cone_momentum_sum(const Gyrostat& g, const RotationStateOf<S>& s) {
  Vec3Of<S> sum = Vec3Of<S>::Zero();
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    for (int i = 0; i < 3; ++i) sum[i] += s.cone_momenta[k] * g.cones[k].axis_B[i];
  return sum;
}

/// Pi = R^T pi_W, N m s.
template <class S>
Vec3Of<S> body_momentum(const RotationStateOf<S>& s) {
  return s.q_WB.conjugate() * s.momentum_W;
}

/// W = It^-1 (Pi - sigma), rad/s, for any momentum Pi.
template <class S>
Vec3Of<S> angular_velocity(const Gyrostat& g, const Vec3Of<S>& body_momentum_B,
                           const Vec3Of<S>& sigma_B) {
  return g.carrier_inverse_B.cast<S>() * (body_momentum_B - sigma_B);
}

/// W_B of a state, rad/s.
template <class S>
Vec3Of<S> angular_velocity(const Gyrostat& g, const RotationStateOf<S>& s) {
  return angular_velocity<S>(g, body_momentum(s), cone_momentum_sum(g, s));
}

/// phi_k' = pi_k / Ic_k - s_k . W, rad/s.
template <class S>
S cone_rate(const Cone& cone, const S& cone_momentum, const Vec3Of<S>& w_B) {
  return cone_momentum * (1.0 / cone.axial_inertia) - cone.axis_B.cast<S>().dot(w_B);
}

/// W . It W / 2 + sum_k pi_k^2 / (2 Ic_k), J.
template <class S>
S kinetic_energy(const Gyrostat& g, const RotationStateOf<S>& s) {
  const Vec3Of<S> carried = body_momentum(s) - cone_momentum_sum(g, s);
  S energy = S(0.5) * carried.dot(g.carrier_inverse_B.cast<S>() * carried);
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    energy += s.cone_momenta[k] * s.cone_momenta[k] * (0.5 / g.cones[k].axial_inertia);
  return energy;
}

/// Creates the state at time 0 from attitude (B to W), angular velocity (rad/s) and, for each cone,
/// spin phi' (rad/s) and angle (rad).
RotationState make_state(const Gyrostat& g, const Mat3& R_WB, const Vec3& w_B,
                         std::span<const double> spins, std::span<const double> angles);

}  // namespace tdbd::dynamics

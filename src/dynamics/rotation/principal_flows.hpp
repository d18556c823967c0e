#pragma once

#include "dynamics/momenta.hpp"
#include "rotation/quaternion.hpp"

namespace tdbd::dynamics {

/// Data of a drift in the frame P of the body: the principal axes of It at the start of the drift,
/// fixed in the body. A rotation of the body about its own axis does not change the spatial
/// momentum, so the momentum in P rotates the opposite way.
template <class S>
struct BodyFlow {
  Vec3Of<S> momentum_P;                                          ///< Pi, N m s
  Vec3Of<S> sigma_P;                                             ///< momentum of the cones, N m s
  Eigen::Quaternion<S> turn = Eigen::Quaternion<S>::Identity();  ///< R <- R turn
  Vec3Of<S> turned_P = Vec3Of<S>::Zero();                        ///< rad, rotation under the cones
};

template <class S>
BodyFlow<S> begin_flow(const Gyrostat& g, const RotationStateOf<S>& s) {
  BodyFlow<S> f;
  const auto to_P = g.principal_axes_B.transpose().cast<S>();
  f.momentum_P = to_P * (s.q_WB.toRotationMatrix().transpose() * s.momentum_W);
  f.sigma_P.setZero();
  if (!g.cones.empty()) f.sigma_P = to_P * cone_momentum_sum(g, s);
  return f;
}

/// Flow of rate (Pi_i - sigma_i)^2 / 2 over h, `h_rate` = h rate: a rotation about axis i.
template <int i, class S>
void flow_about_axis(double h_rate, BodyFlow<S>& f) {
  constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
  const S half = 0.5 * h_rate * (f.momentum_P[i] - f.sigma_P[i]);
  const rotation::CosSinc<S> t = rotation::cos_sinc<S>(half * half);
  const S c = t.cos, s = t.sinc * half;
  const S Pj = f.momentum_P[j], Pk = f.momentum_P[k];
  f.momentum_P[j] += 2.0 * s * (c * Pk - s * Pj);
  f.momentum_P[k] -= 2.0 * s * (c * Pj + s * Pk);
  const Vec3Of<S> v = f.turn.vec();
  const S w = f.turn.w();
  f.turn.w() = w * c - v[i] * s;
  f.turn.vec()[i] = v[i] * c + w * s;
  f.turn.vec()[j] = v[j] * c + v[k] * s;
  f.turn.vec()[k] = v[k] * c - v[j] * s;
  f.turned_P[i] += 2.0 * half;
}

/// Body part of the flow of |Pi - sigma|^2 / 2 times `h_rate`: exp(-h_rate sigma). The cones follow
/// the mean of the body's momentum over the flow. The other part, exp(h_rate pi) in space, does not
/// change Pi.
template <class S>
void flow_spherical(double h_rate, BodyFlow<S>& f) {
  const Vec3Of<S> v = h_rate * f.sigma_P;
  const rotation::Stumpff<S> c = rotation::stumpff<S>(v.squaredNorm());
  const Vec3Of<S> vP = v.cross(f.momentum_P), vvP = v.cross(vP);
  f.turned_P += h_rate * (f.momentum_P + c.c2 * vP + c.c3 * vvP - f.sigma_P);
  f.momentum_P += c.c1 * vP + c.c2 * vvP;
  f.turn = f.turn * rotation::quaternion_exp<S>(-v);
}

/// Advances the cone angles over h: their own spin minus the rotation of the body.
template <class S>
void turn_cones(const Gyrostat& g, double h, const Vec3Of<S>& turned_B, RotationStateOf<S>& s) {
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    s.cone_angles[k] += h / g.cones[k].axial_inertia * s.cone_momenta[k] -
                        g.cones[k].axis_B.cast<S>().dot(turned_B);
}

/// Applies the rotation, R <- R turn, and renormalizes.
template <class S>
void apply_turn(const Gyrostat& g, const BodyFlow<S>& f, RotationStateOf<S>& s) {
  const Vec3Of<S> v = g.principal_axes_B.cast<S>() * f.turn.vec();
  s.q_WB = s.q_WB * Eigen::Quaternion<S>(f.turn.w(), v[0], v[1], v[2]);
  rotation::renormalise(s.q_WB);
}

/// The last flow of a drift, after apply_turn: a rotation about axis i applied directly to the
/// attitude, whose norm stays 1 up to rounding. The processor can apply the earlier rotation while
/// it computes the angle of this one.
template <int i, class S>
void last_flow_about_axis(const Gyrostat& g, double h_rate, BodyFlow<S>& f, RotationStateOf<S>& s) {
  const S half = 0.5 * h_rate * (f.momentum_P[i] - f.sigma_P[i]);
  const rotation::CosSinc<S> t = rotation::cos_sinc<S>(half * half);
  const Vec3Of<S> v = (t.sinc * half) * g.principal_axes_B.col(i).cast<S>();
  s.q_WB = s.q_WB * Eigen::Quaternion<S>(t.cos, v[0], v[1], v[2]);
  f.turned_P[i] += 2.0 * half;
}

/// Advances the cone angles over h, after the last flow.
template <class S>
void end_flow(const Gyrostat& g, double h, const BodyFlow<S>& f, RotationStateOf<S>& s) {
  if (!g.cones.empty()) turn_cones<S>(g, h, g.principal_axes_B.cast<S>() * f.turned_P, s);
}

}  // namespace tdbd::dynamics

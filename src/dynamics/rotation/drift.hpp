#pragma once

#include <type_traits>

#include "dynamics/integrator.hpp"
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

/// @file
/// Implicit drifts, dynamics (5) and (6), which solve for the rotation vector T of the whole drift:
///   T = h It^-1 (m(T) - sigma),   R <- R exp(T),   phi_k <- phi_k + h pi_k / Ic_k - s_k . T.
/// Any T conserves the spatial momentum; the solution makes the drift second order.

/// The momentum m(T) used for the whole drift.
enum class LieMomentum {
  middle,  ///< exp(-T/2) Pi: method of the thesis, reconstructed (5.4.3); not symplectic
  mean,    ///< mean of exp(-s T) Pi over s in [0, 1]: symplectic
};

/// Stopping criteria of the Newton iteration.
struct LieSolve {
  double small_update = 1e-8;  ///< relative to |T|: the iteration stops after an update this small
  int iterations = 20;         ///< maximum
};

/// The momentum of the drift and its derivative with respect to T.
template <class S>
struct LieTerm {
  Vec3Of<S> m;
  Eigen::Matrix<S, 3, 3> by_T;
};

template <class S>
Eigen::Matrix<S, 3, 3> cross_matrix(const Vec3Of<S>& a) {
  Eigen::Matrix<S, 3, 3> m;
  m << S(0), -a[2], a[1], a[2], S(0), -a[0], -a[1], a[0], S(0);
  return m;
}

/// exp(-T/2) P; its derivative is (1/2) skew(m) dexp_{-T/2}.
template <class S>
LieTerm<S> middle_momentum(const Vec3Of<S>& T, const Vec3Of<S>& P) {
  const Vec3Of<S> v = -0.5 * T;
  const rotation::Stumpff<S> c = rotation::stumpff<S>(v.squaredNorm());
  const Vec3Of<S> vP = v.cross(P);
  LieTerm<S> term;
  term.m = P + c.c1 * vP + c.c2 * v.cross(vP);
  const Eigen::Matrix<S, 3, 3> X = cross_matrix<S>(v);
  const Eigen::Matrix<S, 3, 3> dexp =
      Eigen::Matrix<S, 3, 3>::Identity() + c.c2 * X + c.c3 * (X * X);
  term.by_T = 0.5 * (cross_matrix<S>(term.m) * dexp);
  return term;
}

/// dexp_T^T P = P - c_2 T x P + c_3 T x (T x P).
template <class S>
LieTerm<S> mean_momentum(const Vec3Of<S>& T, const Vec3Of<S>& P) {
  const rotation::Stumpff<S> c = rotation::stumpff<S>(T.squaredNorm());
  const Vec3Of<S> TP = T.cross(P), TTP = T.cross(TP);
  const S c2_slope = 2.0 * c.c4 - c.c3, c3_slope = 3.0 * c.c5 - c.c4;  // twice the derivatives by x
  LieTerm<S> term;
  term.m = P - c.c2 * TP + c.c3 * TTP;
  term.by_T = c.c2 * cross_matrix<S>(P) -
              c.c3 * (cross_matrix<S>(TP) + cross_matrix<S>(T) * cross_matrix<S>(P));
  term.by_T += (c3_slope * TTP - c2_slope * TP) * T.transpose();
  return term;
}

template <class S>
LieTerm<S> lie_momentum(LieMomentum which, const Vec3Of<S>& T, const Vec3Of<S>& P) {
  return which == LieMomentum::middle ? middle_momentum<S>(T, P) : mean_momentum<S>(T, P);
}

/// Extra Newton updates for scalars with derivatives, which converge one step after the values.
template <class S>
inline constexpr int derivative_lag = std::is_floating_point_v<S> ? 0 : 1;

/// Whether the Newton iteration converged to the rotation of the drift.
enum class LieOutcome { solved, too_long };

/// Solves It T = h (m(T) - sigma) by Newton's method from the second-order guess h W + (h^2/2)
/// It^-1 (P x W). Returns `too_long` if the iteration does not converge, or exceeds half a turn,
/// where the rotation vector is not unique.
template <class S>
LieOutcome solve_lie(const Gyrostat& g, LieMomentum which, double h, const Vec3Of<S>& P,
                     const Vec3Of<S>& sigma, const LieSolve& options, Vec3Of<S>& T) {
  constexpr double half_turn_squared = 9.869604401089358;
  const Eigen::Matrix<S, 3, 3> It = g.carrier_B.cast<S>(), inverse = g.carrier_inverse_B.cast<S>();
  const Vec3Of<S> w = inverse * (P - sigma);
  T = h * w + (0.5 * h * h) * (inverse * P.cross(w));
  int updates_left = options.iterations, last = derivative_lag<S>;
  while (updates_left-- > 0) {
    const LieTerm<S> term = lie_momentum<S>(which, T, P);
    const Eigen::Matrix<S, 3, 3> slope = It - h * term.by_T;
    const Vec3Of<S> update = slope.inverse() * (h * (term.m - sigma) - It * T);
    T += update;
    if (!(T.squaredNorm() < half_turn_squared)) return LieOutcome::too_long;
    const bool small =
        update.squaredNorm() <= options.small_update * options.small_update * T.squaredNorm();
    if (small && last-- == 0) return LieOutcome::solved;
  }
  return LieOutcome::too_long;
}

/// One drift over h. The state is unchanged if the result is `too_long`.
template <class S>
[[gnu::flatten]] LieOutcome drift_lie(const Gyrostat& g, LieMomentum which, double h,
                                      const LieSolve& options, RotationStateOf<S>& s) {
  Vec3Of<S> T;
  const Vec3Of<S> P = body_momentum(s), sigma = cone_momentum_sum(g, s);
  if (solve_lie<S>(g, which, h, P, sigma, options, T) == LieOutcome::too_long)
    return LieOutcome::too_long;
  s.q_WB = s.q_WB * rotation::quaternion_exp<S>(T);
  rotation::renormalise(s.q_WB);
  turn_cones<S>(g, h, T, s);
  return LieOutcome::solved;
}

/// @file
/// Explicit drifts. The kinetic energy is split into parts whose flows are rotations, composed
/// symmetrically. Each flow is exact, so the drift is symplectic and does not change the spatial
/// momentum.

/// The flows between the two outer flows of the split drift: 3 S 3. Without cones, S acts only in
/// space and commutes with the others.
template <class S>
void inner_flows(const Gyrostat& g, double h, double inner_rate, BodyFlow<S>& f) {
  if (g.cones.empty()) {
    if (inner_rate != 0.0) flow_about_axis<2>(h * inner_rate, f);
    return;
  }
  if (inner_rate != 0.0) flow_about_axis<2>(0.5 * h * inner_rate, f);
  flow_spherical(h * g.principal_rates[1], f);
  if (inner_rate != 0.0) flow_about_axis<2>(0.5 * h * inner_rate, f);
}

/// The flows in the body's frame. A symmetric body without cones needs only one rotation about its
/// axis.
template <int outer, class S>
void split_flows(const Gyrostat& g, double h, double outer_rate, double inner_rate,
                 RotationStateOf<S>& s) {
  BodyFlow<S> f = begin_flow(g, s);
  const Eigen::Quaternion<S> in_space =
      rotation::quaternion_exp<S>(h * g.principal_rates[1] * s.momentum_W);
  s.q_WB = in_space * s.q_WB;
  if (g.cones.empty() && inner_rate == 0.0) {
    rotation::renormalise(s.q_WB);
    last_flow_about_axis<outer>(g, h * outer_rate, f, s);
    return;
  }
  flow_about_axis<outer>(0.5 * h * outer_rate, f);
  inner_flows(g, h, inner_rate, f);
  apply_turn(g, f, s);
  last_flow_about_axis<outer>(g, 0.5 * h * outer_rate, f, s);
  end_flow(g, h, f, s);
}

/// Dynamics (7): splits the kinetic energy into |Pi - sigma|^2 / (2 j), where j is the middle
/// principal inertia, and the two axes whose inertia differs from it, in the order 1 3 S 3 1. For
/// an axisymmetric body one axis remains, and the attitude of a free body is exact if the momentum
/// of its cones is along that axis.
template <class S>
[[gnu::flatten]] void drift_split(const Gyrostat& g, double h, RotationStateOf<S>& s) {
  const Vec3& rate = g.principal_rates;
  const double low = rate[0] - rate[1], high = rate[2] - rate[1];
  if (low != 0.0)
    split_flows<0>(g, h, low, high, s);
  else
    split_flows<2>(g, h, high, 0.0, s);
}

/// One rotation about each principal axis of It, in the order 1 2 3 2 1.
template <class S>
[[gnu::flatten]] void drift_three_axis(const Gyrostat& g, double h, RotationStateOf<S>& s) {
  const Vec3 h_rate = h * g.principal_rates;
  BodyFlow<S> f = begin_flow(g, s);
  flow_about_axis<0>(0.5 * h_rate[0], f);
  flow_about_axis<1>(0.5 * h_rate[1], f);
  flow_about_axis<2>(h_rate[2], f);
  flow_about_axis<1>(0.5 * h_rate[1], f);
  apply_turn(g, f, s);
  last_flow_about_axis<0>(g, 0.5 * h_rate[0], f, s);
  end_flow(g, h, f, s);
}

/// One torque-free drift over h. Only an implicit drift can fail (`too_long`); the state is then
/// unchanged.
template <class S>
LieOutcome drift(const Gyrostat& g, Drift kind, double h, RotationStateOf<S>& s) {
  switch (kind) {
    case Drift::split:
      drift_split(g, h, s);
      return LieOutcome::solved;
    case Drift::three_axis:
      drift_three_axis(g, h, s);
      return LieOutcome::solved;
    case Drift::lie_midpoint:
      return drift_lie(g, LieMomentum::middle, h, LieSolve{}, s);
    case Drift::lie_mean:
      return drift_lie(g, LieMomentum::mean, h, LieSolve{}, s);
  }
  return LieOutcome::too_long;
}

/// Advances the state from one kick to the next by `drifts` drifts, over h in total. Counts the
/// turns of the twist.
template <class S>
LieOutcome coast(const Gyrostat& g, Drift kind, int drifts, double h, RotationStateOf<S>& s) {
  for (int i = 0; i < drifts; ++i) {
    const Eigen::Quaternion<S> before = s.q_WB;
    if (drift(g, kind, h / drifts, s) == LieOutcome::too_long) return LieOutcome::too_long;
    s.turns += rotation::double_turns_between(before, s.q_WB);
  }
  return LieOutcome::solved;
}

}  // namespace tdbd::dynamics

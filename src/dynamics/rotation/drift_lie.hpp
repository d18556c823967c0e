#pragma once

#include <type_traits>

#include "dynamics/rotation/principal_flows.hpp"

namespace tdbd::dynamics {

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

}  // namespace tdbd::dynamics

#pragma once

#include "dynamics/rotation/principal_flows.hpp"

namespace tdbd::dynamics {

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

}  // namespace tdbd::dynamics

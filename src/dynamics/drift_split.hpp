#pragma once

#include "dynamics/principal_flows.hpp"

namespace tdbd::dynamics {

/// Explicit drifts: the kinetic energy is split into parts whose flows are rotations, composed
/// symmetrically. Each flow is exact, so the drift is symplectic, and the spatial momentum is not
/// touched at all.

/// Kinetic energy as |Pi - sigma|^2 / (2 j), j the middle principal inertia, and the two axes whose
/// inertia differs from it, in the order 1 3 S 3 1. Of an axisymmetric body one axis is left, and a
/// free body's attitude is exact when its cones' momentum lies along the axis. Without cones S acts
/// in space alone and commutes with the rest.
template <class S>
[[gnu::flatten]] void drift_split(const Gyrostat& g, double h, RotationStateOf<S>& s) {
  const double rate = 1.0 / g.principal[1];
  const double low = 1.0 / g.principal[0] - rate, high = 1.0 / g.principal[2] - rate;
  const Eigen::Quaternion<S> in_space = rotation::quaternion_exp<S>(h * rate * s.momentum_W);
  BodyFlow<S> f = begin_flow(g, s);
  s.q_WB = in_space * s.q_WB;
  if (g.cones.empty() && high == 0.0) {
    flow_about_axis<0>(h * low, f);
  } else {
    if (low != 0.0) flow_about_axis<0>(0.5 * h * low, f);
    if (g.cones.empty()) {
      if (high != 0.0) flow_about_axis<2>(h * high, f);
    } else {
      if (high != 0.0) flow_about_axis<2>(0.5 * h * high, f);
      flow_spherical(h * rate, f);
      if (high != 0.0) flow_about_axis<2>(0.5 * h * high, f);
    }
    if (low != 0.0) flow_about_axis<0>(0.5 * h * low, f);
  }
  end_flow(g, h, f, s);
}

/// One rotation about each principal axis of It, in the order 1 2 3 2 1.
template <class S>
[[gnu::flatten]] void drift_three_axis(const Gyrostat& g, double h, RotationStateOf<S>& s) {
  const Vec3 h_rate = h * g.principal.cwiseInverse();
  BodyFlow<S> f = begin_flow(g, s);
  flow_about_axis<0>(0.5 * h_rate[0], f);
  flow_about_axis<1>(0.5 * h_rate[1], f);
  flow_about_axis<2>(h_rate[2], f);
  flow_about_axis<1>(0.5 * h_rate[1], f);
  flow_about_axis<0>(0.5 * h_rate[0], f);
  end_flow(g, h, f, s);
}

}  // namespace tdbd::dynamics

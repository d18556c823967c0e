#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace tdbd::dynamics {

template <class S>
using Vec3Of = Eigen::Matrix<S, 3, 1>;

/// Attitude, momenta and cone angles of a gyrostat. The primary momentum is the spatial one, so
/// that it is conserved bit for bit when no torque acts; the body's is R^T pi_W. S is double, or a
/// number that carries derivatives. Frames: W space, B bit.
template <class S>
struct RotationStateOf {
  Eigen::Quaternion<S> q_WB = Eigen::Quaternion<S>::Identity();  ///< unit; R takes B to W
  Vec3Of<S> momentum_W = Vec3Of<S>::Zero();  ///< N m s, body and cones, about the centre of mass
  std::vector<S> cone_angles;                ///< phi_k, rad, unwrapped
  std::vector<S> cone_momenta;               ///< pi_k, N m s, about the cone's axis
  long turns = 0;     ///< double turns that the twist about space z has passed
  double time = 0.0;  ///< s
};

using RotationState = RotationStateOf<double>;

}  // namespace tdbd::dynamics

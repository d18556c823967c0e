#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace tdbd::dynamics {

template <class S>
using Vec3Of = Eigen::Matrix<S, 3, 1>;

/// Attitude, momenta and cone angles of a gyrostat. The primary variable is the spatial momentum,
/// so it is bitwise constant without torque; the momentum of the body is R^T pi_W. S is double, or
/// a scalar type with derivatives. Frames: W space, B bit.
template <class S>
struct RotationStateOf {
  Eigen::Quaternion<S> q_WB = Eigen::Quaternion<S>::Identity();  ///< unit; R maps B to W
  Vec3Of<S> momentum_W = Vec3Of<S>::Zero();  ///< N m s, body and cones, about the centre of mass
  std::vector<S> cone_angles;                ///< phi_k, rad, unwrapped
  std::vector<S> cone_momenta;               ///< pi_k, N m s, about the cone's axis
  long turns = 0;     ///< number of double turns in the twist about the z axis of space
  double time = 0.0;  ///< s

  template <class Archive>
  void serialize(Archive& a) {
    a(q_WB, momentum_W, cone_angles, cone_momenta, turns, time);
  }
};

using RotationState = RotationStateOf<double>;

}  // namespace tdbd::dynamics

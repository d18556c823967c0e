#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/types.hpp"

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

/// A cone of a bit. It rotates about an axis fixed in the bit and is dynamically symmetric about
/// it. Frame B: the bit.
struct Cone {
  Vec3 axis_B = Vec3::UnitZ();  ///< s_k, unit vector
  double axial_inertia = 0.0;   ///< Ic_k, kg m2, about the axis
};

/// A rigid body with any number of spinning cones, including none (thesis: 5.1-5.3; dynamics (1) to
/// (3)). Assumption: every cone is symmetric about its axis and its centre of mass is on it, so I
/// does not depend on the cone angles.
struct Gyrostat {
  Mat3 inertia_B = Mat3::Identity();  ///< I, kg m2, with locked cones, about the centre of mass
  std::vector<Cone> cones;

  // Derived by make_gyrostat.
  Mat3 carrier_B = Mat3::Identity();          ///< It = I - sum_k Ic_k s_k s_k^T
  Mat3 carrier_inverse_B = Mat3::Identity();  ///< It^-1
  Vec3 principal = Vec3::Ones();              ///< principal values of It, ascending, kg m2
  Vec3 principal_rates = Vec3::Ones();        ///< their inverses, 1/(kg m2)
  Mat3 principal_axes_B = Mat3::Identity();   ///< their axes as columns, right-handed
};

/// Whether physically impossible inertias are rejected. Published benchmarks use some.
enum class InertiaCheck { on, off };

/// Why these cannot be the inertias of a body with cones, with the invalid value; empty if they
/// can. `off` checks only what the equations require: symmetric, finite, It positive definite.
std::string inertia_problem(const Mat3& inertia_B, const std::vector<Cone>& cones,
                            InertiaCheck check);

/// Normalizes the axes and computes the derived members. Throws InputError with the result of
/// inertia_problem.
Gyrostat make_gyrostat(const Mat3& inertia_B, std::vector<Cone> cones,
                       InertiaCheck check = InertiaCheck::on);

}  // namespace tdbd::dynamics

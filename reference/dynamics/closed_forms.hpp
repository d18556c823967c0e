#pragma once

#include <vector>

#include "core/types.hpp"

/// Motions of a rotating body that have a closed form. Frames: W space, B bit; the axis of a
/// symmetric body is e3 of B. SI.
namespace tdbd::reference {

struct Turning {
  Mat3 R_WB = Mat3::Identity();  ///< takes B to W
  Vec3 w_B = Vec3::Zero();       ///< rad/s
};

/// A symmetric body, optionally with a cone that spins on its axis.
struct SymmetricBody {
  double transverse = 1.0;     ///< kg m2
  double axial = 1.0;          ///< kg m2, without the cone's axial inertia
  double cone_momentum = 0.0;  ///< pi, N m s; constant
};

/// Free motion: the momentum pi_W is constant, and W = P / transverse + (a constant multiple of
/// e3), so
///   R(t) = exp(t pi_W / transverse) R0 exp(t lambda e3).
Turning free_symmetric_body(const SymmetricBody& body, const Turning& start, double t);

/// A free body with three different principal inertias (kg m2, about the axes of B, in any order).
/// The angular velocity is given by Jacobi's elliptic functions. The attitude follows from it and
/// from the angle that the body has rotated about the momentum, which is a quadrature (an elliptic
/// integral of the third kind). Valid on both sides of the separatrix and on it. Landau and
/// Lifshitz, Mechanics, section 37.
Turning free_asymmetric_body(const Vec3& principal, const Turning& start, double t);

/// Rates of steady precession, rad/s, in ascending order, of a top whose axis is tilted by `tilt`
/// (rad) from ez, with W3 = axial_rate (rad/s), under V = gravity_moment ez . R e3:
///   transverse cos(tilt) rate^2 - P3 rate + gravity_moment = 0,  P3 = axial W3 + cone_momentum.
/// None if it spins too slowly; one if the axis is horizontal.
std::vector<double> steady_precession_rates(const SymmetricBody& top, double gravity_moment,
                                            double tilt, double axial_rate);

/// The state of the top at time t if it precesses at one of these rates. At t = 0 it is tilted
/// about ex: R = exp(t rate ez) exp(tilt ex) exp(t spin e3).
Turning steady_precession(double tilt, double axial_rate, double rate, double t);

/// Rotation about one principal axis, which is also the cone's axis.
struct AxialMotion {
  double angle = 0.0;       ///< rad
  double rate = 0.0;        ///< rad/s
  double cone_angle = 0.0;  ///< rad, relative to the body
  double cone_rate = 0.0;   ///< rad/s, relative to the body
};

/// Inertias and constant torques about that axis.
struct AxialBody {
  double inertia = 1.0;       ///< kg m2, without the cone
  double cone_inertia = 1.0;  ///< kg m2
  double torque = 0.0;        ///< N m, on the body
  double cone_torque = 0.0;   ///< N m, internal: on the cone, and opposite on the body
};

/// Both accelerate uniformly: angle = W t + (torque - cone_torque) t^2 / (2 inertia).
AxialMotion constant_axial_torque(const AxialBody& body, const AxialMotion& start, double t);

}  // namespace tdbd::reference

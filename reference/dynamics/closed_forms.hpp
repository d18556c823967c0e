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

/// A symmetric body, with or without a cone that spins on its axis.
struct SymmetricBody {
  double transverse = 1.0;     ///< kg m2
  double axial = 1.0;          ///< kg m2, without the cone's axial inertia
  double cone_momentum = 0.0;  ///< pi, N m s; constant
};

/// Free: the momentum pi_W is fixed, and W = P / transverse + (a multiple of e3 that is constant),
/// so
///   R(t) = exp(t pi_W / transverse) R0 exp(t lambda e3).
Turning free_symmetric_body(const SymmetricBody& body, const Turning& start, double t);

/// A free body with three different principal inertias (kg m2, about the axes of B, in any order):
/// the angular velocity by Jacobi's elliptic functions; the attitude from it, and from the angle
/// that it has turned about the momentum, which is one quadrature (an elliptic integral of the
/// third kind). On both sides of the separatrix and on it. Landau and Lifshitz, Mechanics,
/// section 37.
Turning free_asymmetric_body(const Vec3& principal, const Turning& start, double t);

/// Rates of steady precession, rad/s, slow one first, of a top with its axis tilted by `tilt` (rad)
/// from ez and W3 = axial_rate (rad/s), under V = gravity_moment ez . R e3:
///   transverse cos(tilt) rate^2 - P3 rate + gravity_moment = 0,  P3 = axial W3 + cone_momentum.
/// None when it spins too slowly; one when the axis is level.
std::vector<double> steady_precession_rates(const SymmetricBody& top, double gravity_moment,
                                            double tilt, double axial_rate);

/// Where the top is at time t when it precesses at one of these rates; at t = 0 it is tilted about
/// ex: R = exp(t rate ez) exp(tilt ex) exp(t spin e3).
Turning steady_precession(double tilt, double axial_rate, double rate, double t);

/// Turning about one principal axis, the cone's axis the same.
struct AxialMotion {
  double angle = 0.0;       ///< rad
  double rate = 0.0;        ///< rad/s
  double cone_angle = 0.0;  ///< rad, against the body
  double cone_rate = 0.0;   ///< rad/s, against the body
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

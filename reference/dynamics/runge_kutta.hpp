#pragma once

#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"
#include "reference/dynamics/ode.hpp"

namespace tdbd::reference {

/// A gyrostat's state in other unknowns than the program's: attitude as a matrix, momentum in the
/// bit's frame. Frames: W space, B bit.
struct GyrostatState {
  double time = 0.0;                    ///< s
  Mat3 R_WB = Mat3::Identity();         ///< takes B to W; nine unknowns, not kept orthogonal
  Vec3 body_momentum_B = Vec3::Zero();  ///< Pi, N m s
  std::vector<double> cone_angles;      ///< phi_k, rad
  std::vector<double> cone_momenta;     ///< pi_k, N m s
  double twist = 0.0;                   ///< rad, about space z; unwrapped if a spring twists
};

/// Converts a state to these unknowns.
GyrostatState matrix_state(const dynamics::RotationState& s);

/// W = It^-1 (Pi - sum pi_k s_k), rad/s, with It computed here from I.
Vec3 bit_angular_velocity(const dynamics::Gyrostat& g, const GyrostatState& s);

/// Kinetic energy of body and cones, potential of gravity and springs, J.
double total_energy(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                    const GyrostatState& s);

/// Equations dynamics (3) for the unknowns R (by rows), Pi, phi, pi and, only if a spring about
/// space z depends on full turns, the twist. Its angle is still computed from R. (Without a spring
/// the twist would only cost steps, because its rate is singular at R ez = -ez.)
RightHandSide gyrostat_equations(const dynamics::Gyrostat& g, const dynamics::Loads& loads);
std::vector<double> unknowns(const GyrostatState& s, const dynamics::Loads& loads);
GyrostatState state_of(std::span<const double> y, std::size_t cones, double time);

struct RungeKuttaRun {
  GyrostatState state;
  long evaluations = 0;  ///< of the right-hand side
};

/// Twin of the program's step (thesis: 5.4, 5.5; dynamics (3), (4)): integrates the gyrostat's
/// motion to t_end > start.time with GSL, at the accuracy of the tolerance. Stops at every sample
/// of a sampled torque, where the right-hand side has a kink. Throws RunError if the tolerance
/// cannot be reached.
RungeKuttaRun runge_kutta(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                          const GyrostatState& start, double t_end,
                          OdeMethod method = OdeMethod::rk8pd, const OdeTolerance& tolerance = {});

}  // namespace tdbd::reference

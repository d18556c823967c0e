#pragma once

namespace tdbd::dynamics {

/// How a gyrostat coasts between two kicks.
enum class Drift {
  split,         ///< spherical gyrostat and principal axes; explicit, symplectic
  three_axis,    ///< one rotation about each principal axis; explicit, symplectic
  lie_midpoint,  ///< the thesis's, as reconstructed (LIEMID[EA]); solves; not symplectic
  lie_mean,      ///< its symplectic twin: the mean momentum in place of the middle one; solves
};

/// How the closing kick evaluates a torque that depends on velocity.
enum class VelocityTorque {
  predicted,  ///< once, at the momentum predicted with the last torque: order 2, one evaluation
  symmetric,  ///< implicitly, the adjoint of the opening kick: reversible, so that it composes
};

/// Options of the step.
struct Integrator {
  Drift drift = Drift::split;
  int drifts_per_step = 1;  ///< the thesis's form has 2
  int order = 2;            ///< 2, 4 (Suzuki), 6 or 8 (Kahan-Li)
  VelocityTorque velocity_torque = VelocityTorque::predicted;
};

}  // namespace tdbd::dynamics

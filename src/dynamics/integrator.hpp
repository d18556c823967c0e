#pragma once

#include <span>

namespace tdbd::dynamics {

/// How a gyrostat coasts between two kicks.
enum class Drift {
  split,         ///< spherical gyrostat and principal axes; explicit, symplectic
  three_axis,    ///< one rotation about each principal axis; explicit, symplectic
  lie_midpoint,  ///< the thesis's, as reconstructed (LIEMID[EA]); implicit; not symplectic
  lie_mean,      ///< its symplectic twin: the mean momentum in place of the middle one; implicit
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

/// Orders that a composition is known for.
inline constexpr int composition_orders[] = {2, 4, 6, 8};

/// Fractions of the step that the stages of a symmetric composition take; they sum to 1. Applied to
/// a symmetric second-order step they give order 2 (one stage), 4 (five: Suzuki, 1990), 6 (nine:
/// Kahan and Li, 1997) or 8 (seventeen: Kahan and Li, 1997). Throws RunError for another order.
std::span<const double> composition(int order);

}  // namespace tdbd::dynamics

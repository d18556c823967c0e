#pragma once

#include <span>

namespace tdbd::dynamics {

/// Methods for the torque-free rotation of a gyrostat between two kicks.
enum class Drift {
  split,         ///< spherical gyrostat and principal axes; explicit, symplectic
  three_axis,    ///< one rotation about each principal axis; explicit, symplectic
  lie_midpoint,  ///< method of the thesis, reconstructed (LIEMID[EA]); implicit; not symplectic
  lie_mean,      ///< symplectic variant: mean momentum instead of the midpoint one; implicit
};

/// How the closing kick evaluates a torque that depends on velocity.
enum class VelocityTorque {
  predicted,  ///< once, at the momentum predicted with the last torque: order 2, one evaluation
  symmetric,  ///< implicitly, the adjoint of the opening kick: reversible, so it can be composed
};

/// Options of the time integration.
struct Integrator {
  Drift drift = Drift::split;
  int drifts_per_step = 1;  ///< 2 in the thesis
  int order = 2;            ///< 2, 4 (Suzuki), 6 or 8 (Kahan-Li)
  VelocityTorque velocity_torque = VelocityTorque::predicted;
};

/// Orders for which a composition is available.
inline constexpr int composition_orders[] = {2, 4, 6, 8};

/// Fractions of the step for the stages of a symmetric composition; they sum to 1. Applied to a
/// symmetric second-order step they give order 2 (one stage), 4 (five: Suzuki, 1990), 6 (nine:
/// Kahan and Li, 1997) or 8 (seventeen: Kahan and Li, 1997). Throws RunError for any other order.
std::span<const double> composition(int order);

}  // namespace tdbd::dynamics

#pragma once

#include "dynamics/loads.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {

/// What acts on a gyrostat at one instant.
template <class S>
struct TorqueOf {
  Vec3Of<S> total_W = Vec3Of<S>::Zero();  ///< N m, from outside, on body and cones
  std::vector<S> cones;                   ///< N m, T_k . s_k: changes of the cones' momenta
};
using Torque = TorqueOf<double>;

/// Whether a load depends on velocity (dampers do).
bool depends_on_velocity(const Loads& loads);

/// Torque of the loads at the state's time, attitude and momenta, into `out` (no allocation once it
/// has the cones' number). Formulation 4; thesis: 5.2.2.
template <class S>
void evaluate(const Gyrostat& g, const Loads& loads, const RotationStateOf<S>& s, TorqueOf<S>& out);

/// Potential energy of gravity and springs, J.
double potential_energy(const Loads& loads, const RotationState& s);

}  // namespace tdbd::dynamics

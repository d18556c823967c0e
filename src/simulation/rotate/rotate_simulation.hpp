#pragma once

#include <vector>

#include "dynamics/rotation/step.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {

/// Conserved quantities: their values at the start and the largest changes over all steps. Momenta
/// in N m s, energies in J.
struct Invariants {
  Vec3 momentum_W = Vec3::Zero();    ///< at the start
  std::vector<double> cone_momenta;  ///< at the start
  double energy = 0.0;               ///< at the start, kinetic and potential
  double energy_scale = 0.0;         ///< |T0| + |V0| + |gravity_moment|; 1 if that is 0
  double energy_drift = 0.0;         ///< |E - E0|
  double momentum_drift_squared = 0.0;
  double vertical_drift = 0.0;       ///< |pi_z - pi_z0|
  double cone_momentum_drift = 0.0;  ///< of any cone
  double quaternion_defect = 0.0;    ///< ||q|^2 - 1|
  double largest_speed = 0.0;        ///< rad/s, of the body after a step

  template <class Archive>
  void serialize(Archive& a) {
    a(momentum_W, cone_momenta, energy, energy_scale, energy_drift, momentum_drift_squared,
      vertical_drift, cone_momentum_drift, quaternion_defect, largest_speed);
  }
};

/// The state of a rotate case during a run.
struct RotateSimulation {
  dynamics::Rotating rotating;
  Invariants invariants;
  long steps_done = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(rotating, invariants, steps_done);
  }
};

/// Returns warnings about a run whose step is too long: the energy of a body without applied torques
/// and damping has changed by more than 1 % of its scale, or the body has turned by more than 0.5 rad
/// in a step although it did not at the start. Both are outside the range of the integrators.
std::vector<CaseWarning> end_warnings(const RotateCase& c, const RotateSimulation& s);

/// Returns the kinetic and potential energy, J.
double total_energy(const RotateCase& c, const dynamics::RotationState& s);

/// Returns the angle about the space's z axis by swing-twist decomposition, unwrapped, rad.
double twist(const dynamics::RotationState& s);

/// Returns the simulation of a case at t = 0.
RotateSimulation start(const RotateCase& c);

/// Makes `steps` more steps and updates the drifts of the invariants at each. Throws RunError if
/// an implicit drift does not converge or the state is no longer finite. The state before a
/// failing step is kept if possible.
void advance(const RotateCase& c, RotateSimulation& s, long steps);

}  // namespace tdbd::simulation

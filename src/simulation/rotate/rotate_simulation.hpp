#pragma once

#include <vector>

#include "dynamics/rotation/step.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {

/// What should not change: its value at the start, and the largest change over all steps. Momenta in
/// N m s, energies in J.
struct Invariants {
  Vec3 momentum_W = Vec3::Zero();    ///< at the start
  std::vector<double> cone_momenta;  ///< at the start
  double energy = 0.0;               ///< at the start, kinetic and potential
  double energy_scale = 0.0;         ///< |T0| + |V0| + |gravity_moment|; 1 when that is 0
  double energy_drift = 0.0;         ///< |E - E0|
  double momentum_drift_squared = 0.0;
  double vertical_drift = 0.0;       ///< |pi_z - pi_z0|
  double cone_momentum_drift = 0.0;  ///< of any cone
  double quaternion_defect = 0.0;    ///< ||q|^2 - 1|

  template <class Archive>
  void serialize(Archive& a) {
    a(momentum_W, cone_momenta, energy, energy_scale, energy_drift, momentum_drift_squared,
      vertical_drift, cone_momentum_drift, quaternion_defect);
  }
};

/// The state of a rotate case as it runs.
struct RotateSimulation {
  dynamics::Rotating rotating;
  Invariants invariants;
  long steps_done = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(rotating, invariants, steps_done);
  }
};

/// Kinetic and potential energy, J.
double total_energy(const RotateCase& c, const dynamics::RotationState& s);

/// Turn about the space's z axis, swing-twist, unwrapped, rad.
double twist(const dynamics::RotationState& s);

/// The case at t = 0.
RotateSimulation start(const RotateCase& c);

/// Makes `steps` more steps and checks every invariant at each. Throws RunError when a drift does not
/// converge or the state is no longer finite; where there is a state before the failing step, it is
/// kept.
void advance(const RotateCase& c, RotateSimulation& s, long steps);

}  // namespace tdbd::simulation

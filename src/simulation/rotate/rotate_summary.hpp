#pragma once

#include <string>

#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// The summary of a rotate case so far as JSON, units in the keys or here: attitude (rows of R_WB),
/// momenta and cone momenta in N m s, angular velocity (bit frame) and cone spins in rad/s, cone
/// angles in rad, energies in J, each as digits that read back to the bit. The drifts are the
/// largest over all steps; energy drifts are over `energy_scale`. Depends on the case alone.
std::string summary_json(const RotateCase& c, const RotateSimulation& s, RunStatus status);

}  // namespace tdbd::simulation

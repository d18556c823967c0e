#pragma once

#include <string>

#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// The summary of a rotate case so far, as JSON. Units stand in its keys or here: attitude (rows of
/// R_WB), momenta and cone momenta in N m s, angular velocity (bit frame) and cone spins in rad/s,
/// cone angles in rad, energies in J; every number has the digits that read back to the same bits.
/// Drifts are the largest over all steps; energy drifts are divided by `energy_scale`. The text
/// depends on the case alone.
std::string summary_json(const RotateCase& c, const RotateSimulation& s, RunStatus status);

}  // namespace tdbd::simulation

#pragma once

#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/exact_flow.hpp"

namespace tdbd::dynamics {

/// In which order the dampers act. Forward at a step's start and backward at its end
/// make the step symmetric.
enum class Sweep { forward, backward };

/// Dampers of string, bearings and rock mount of a system without a wall, one after another, each
/// exact over `time` (s), at positions that stand still. Kinetic energy changes by what the
/// ledger says: losses, none of them negative, and the work of the top on the string's dampers.
void dissipate(const DrillingSystem& system, const Configuration& at, Sweep sweep, double time,
               DrillingState& state, EnergyLedger& ledger);

}  // namespace tdbd::dynamics

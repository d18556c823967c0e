#pragma once

#include <string>

#include "dynamics/drilling/drilling_step.hpp"

namespace tdbd::dynamics {

/// Bounds beyond which the results of a run are meaningless.
struct DivergenceBounds {
  double speed = 100.0;           ///< m/s, of bit and rock
  double angular_speed = 1e4;     ///< rad/s, of bit and cones
  double energy_residual = 10.0;  ///< relative to the throughput of the energy ledger
  double least_energy = 1.0;      ///< J, added to the bound, for a bit at rest
};

/// Checks a closed step for divergence. Returns the diverged quantity with its value and the time,
/// or an empty string. Speeds are means over the closing kick. Quantities that are not finite are
/// reported first, and the wrench before the state, because it is the cause.
std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds = {});

}  // namespace tdbd::dynamics

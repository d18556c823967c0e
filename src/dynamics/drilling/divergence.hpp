#pragma once

#include <string>

#include "dynamics/drilling/drilling_step.hpp"

namespace tdbd::dynamics {

/// Beyond these a run has lost what it computes.
struct DivergenceBounds {
  double speed = 100.0;           ///< m/s, of bit and rock
  double angular_speed = 1e4;     ///< rad/s, of bit and cones
  double energy_residual = 10.0;  ///< of the energy at the start and all that came and went
  double least_energy = 1.0;      ///< J, on top of that: a bit at rest has none
};

/// What of a closed step has diverged, with its value and the time (speeds: means over the closing
/// kick); empty when nothing has. Looks at numbers that are not finite first, the wrench before the
/// state: it is the cause.
std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds = {});

}  // namespace tdbd::dynamics

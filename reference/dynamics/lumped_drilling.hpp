#pragma once

#include "reference/dynamics/lumped_forces.hpp"

namespace tdbd::reference {

/// What a bit on a string does (dynamics (9) to (12); thesis: eqs. 2.1-2.3), by Runge-Kutta.
struct LumpedRun {
  LumpedState state;
  LumpedEnergy energy;   ///< J since the start
  long evaluations = 0;  ///< of the right-hand side
};

/// The same state in these unknowns, at t = 0.
LumpedState lumped_state(const dynamics::DrillingSystem& system, const dynamics::DrillingState& s);

/// Twin of the program's drilling step: motion to t_end > the state's time by GSL at the
/// tolerance's accuracy. Stops at every entry of the top's schedules, where forces jump or have a
/// kink. Throws RunError when the tolerance is out of reach: a wall that is touched and left makes
/// kinks too.
LumpedRun lumped_drilling(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                          const LumpedState& start, double t_end,
                          const OdeTolerance& tolerance = {1e-13, 1e-13});

/// The same by the classical Runge-Kutta method in equal steps, for comparison of methods.
LumpedRun lumped_drilling_rk4(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                              const LumpedState& start, double t_end, int steps);

}  // namespace tdbd::reference

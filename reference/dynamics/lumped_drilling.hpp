#pragma once

#include "reference/dynamics/lumped_forces.hpp"

namespace tdbd::reference {

/// Motion of a bit on a string (dynamics (9) to (12); thesis: eqs. 2.1-2.3), by Runge-Kutta.
struct LumpedRun {
  LumpedState state;
  LumpedEnergy energy;   ///< J since the start
  long evaluations = 0;  ///< of the right-hand side
};

/// Converts a state to these unknowns, at t = 0.
LumpedState lumped_state(const dynamics::DrillingSystem& system, const dynamics::DrillingState& s);

/// Twin of the program's drilling step: integrates the motion to t_end > the state's time with GSL
/// at the accuracy of the tolerance. Stops at every entry of the top's schedules, where forces are
/// discontinuous or have a kink. Throws RunError if the tolerance cannot be reached: contact with a
/// wall and its loss are kinks, too.
LumpedRun lumped_drilling(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                          const LumpedState& start, double t_end,
                          const OdeTolerance& tolerance = {1e-13, 1e-13});

/// The same by the classical Runge-Kutta method with equal steps, for comparison of methods.
LumpedRun lumped_drilling_rk4(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                              const LumpedState& start, double t_end, int steps);

}  // namespace tdbd::reference

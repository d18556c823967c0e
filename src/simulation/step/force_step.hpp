#pragma once

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Asks the laws what the rock does to the bit at the end of a step, and notes it for the run's
/// means. Where forces move the bit they are asked at the momenta that the last ones predict, and
/// close the step of the equations of motion. Throws RunError where that motion diverges; it is
/// then as it was before the step.
void ask_forces(const Case& c, const MeasuredStep& moved, Simulation& s);

}  // namespace tdbd::simulation

#pragma once

#include "dynamics/drilling/drilling_step.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/step/cone_motion.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// @file
/// How the simulation turns the equations of motion (src/dynamics) into places of the bit over the
/// rock, and loads on its parts into impulses.

dynamics::Drilling start_drive(const Case& c);

/// Where the state has the bit.
Place place_of(const dynamics::DrillingSystem& system, const dynamics::DrillingState& state);

/// How a state moves the bit over the rock, in the rock's frame.
BitVelocity velocity_of(const dynamics::DrillingSystem& system,
                        const dynamics::DrillingState& state);

/// The loads as the equations of motion take them: torques about the centre of mass, the opposite
/// force on the rock, and the impulses of the cones' own spins at the end of the step.
/// X_RB: where the loads were summed, about its origin.
dynamics::Wrench wrench_of(const dynamics::DrillingSystem& system, const BitLoads& loads,
                           const Pose& X_RB);

/// Takes the cones' angles and speeds from the state after a step of dt (s).
void follow_cones(const dynamics::DrillingState& state, double dt, std::vector<ConeState>& cones);

}  // namespace tdbd::simulation

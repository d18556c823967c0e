#pragma once

#include "dynamics/drilling/drilling_step.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/step/cone_motion.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// @file
/// Interface between the simulation and the equations of motion (src/dynamics): converts states
/// into poses of the bit relative to the rock, and loads on parts into impulses.

dynamics::Drilling start_drive(const Case& c);

/// Pose of the bit in this state.
Place place_of(const dynamics::DrillingSystem& system, const dynamics::DrillingState& state);

/// Velocity of the bit relative to the rock, in the frame of the rock.
BitVelocity velocity_of(const dynamics::DrillingSystem& system,
                        const dynamics::DrillingState& state);

/// Converts loads to a wrench for the equations of motion: torques about the centre of mass, the
/// opposite force on the rock, and the impulses on the cones' own spins at the end of the step.
/// X_RB is the pose at which the loads were summed; they are about its origin.
dynamics::Wrench wrench_of(const dynamics::DrillingSystem& system, const BitLoads& loads,
                           const Pose& X_RB);

/// Sets the angles and speeds of the cones from the state after a step of dt (s).
void follow_cones(const dynamics::DrillingState& state, double dt, std::vector<ConeState>& cones);

}  // namespace tdbd::simulation

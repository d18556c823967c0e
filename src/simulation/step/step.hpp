#pragma once

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

// The parts of a time step, thesis fig. 4.2, in their order; step() calls them.

/// Takes bit and cones to the end of the step: along the prescribed motion, or as forces move it.
Move drift(const Case& c, State& state, Work& work);

/// Every part takes the rock that it sweeps; the ledger of volume notes it.
void cut(const Move& move, State& state, Work& work);

/// Sections of uncut rock ahead of the faces, and contact areas of all parts.
void measure(const Case& c, const Move& move, State& state, Work& work);

/// The contacts of parts that rub, beside those of parts that cut, at this pose over the rock.
void measure_rubbing(const Case& c, const Pose& X_WB, const State& state, Work& work);

/// Evaluates the force laws on the step's cuts: at the velocity of the prescribed motion, or, where
/// forces move the bit, at the momenta that the last ones predict.
void apply_forces(const Case& c, const Move& move, const State& state, Work& work);

/// Closes the step of the equations of motion with the loads; nothing for a prescribed motion.
/// Throws RunError where the motion diverges.
void kick(const Case& c, const Move& move, State& state, Work& work);

/// Adds the step to the statistics.
void record(const Case& c, const Move& move, Simulation& s);

/// Repairs the surface and trims its wall, every so many steps.
void maintain(const Case& c, State& state, Work& work);

/// Numbers the surface's vertices and triangles by place, every so many steps of the motion.
void renumber(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation

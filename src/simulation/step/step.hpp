#pragma once

#include <cstdint>
#include <vector>

#include "bit/bit.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The bit after the start of waiting parts (bit::Part::start). `started` has one entry per part,
/// or is empty if no part waits.
bit::Bit started_bit(bit::Bit bit, const std::vector<std::uint8_t>& started);

/// Whether any part of the bit is still waiting.
bool any_part_waits(const bit::Bit& bit, const std::vector<std::uint8_t>& started);

/// Starts the parts whose event occurs before the middle of the next step. A start is permanent: it
/// is not undone if the bit lifts. The rock inside a part that starts is removed in that step as if
/// swept. Throws RunError if the centre of a part that starts to cut is below the rock's surface,
/// where rock cannot be removed.
void start_due_parts(const Case& c, State& state, Work& work);

// The phases of a time step, thesis fig. 4.2, in their order. step() calls them.

/// Moves bit and cones to the end of the step, by prescribed or free motion.
Move drift(const Case& c, State& state, Work& work);

/// Every part removes the rock that it sweeps. Updates the volume ledger.
void cut(const Move& move, State& state, Work& work);

/// Measures sections of uncut rock ahead of the faces, and contact areas of all parts.
void measure(const Case& c, const Move& move, State& state, Work& work);

/// Measures the contacts of rubbing parts next to those of cutting parts, at this pose relative to
/// the rock.
void measure_rubbing(const Case& c, const Pose& X_WB, const State& state, Work& work);

/// Evaluates the force laws on the cuts of the step: at the velocity of the prescribed motion, or
/// in free motion at the momenta predicted from the last forces.
void apply_forces(const Case& c, const Move& move, const State& state, Work& work);

/// Computes the initial forces if pressing parts touch the rock at the start: those of the opening
/// kick, at the velocity of the first drift. Without them the bit would fall freely during the
/// first step.
void apply_opening_forces(const Case& c, State& state, Work& work);

/// Completes the step of the equations of motion with the loads. No effect for a prescribed motion.
/// Throws RunError if the motion diverges.
void kick(const Case& c, const Move& move, State& state, Work& work);

/// Adds the step to the statistics.
void record(const Case& c, const Move& move, Simulation& s);

/// Repairs the surface and trims its wall, if due.
void maintain(const Case& c, State& state, Work& work);

/// Renumbers the vertices and triangles of the surface by position, if due.
void renumber(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation

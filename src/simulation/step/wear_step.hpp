#pragma once

#include <optional>

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The pieces that wear: the cutters, and the teeth and gage pads with a law.
std::vector<bit::WearSolid> solids_of(const Case& c);

/// The wear of a case's bit at the start; none if the bit does not wear.
std::optional<WearState> start_wear(const Case& c);

/// What a wearing bit keeps beside its state: all of it follows from the case, whose bit is not worn
/// by the run, and the state. None if the bit does not wear.
std::optional<WearWork> wear_work(const Case& c, const State& state);

/// Takes a wear step if one is due: if the window is as long as the case allows, or a flat might
/// otherwise grow by more than WearPlan::largest_growth before the end of the next time step. The
/// parts of the worn cutters are cut from those of the case, the bit is prepared again, and the
/// motion of a bit that forces move continues with the worn mass: the velocities of the bit's points
/// do not change. The worn bit is a part of the one before, so that no contact arises. Throws WearEnd;
/// the simulation is then as it was.
void wear_if_due(const Case& c, Simulation& s);

/// Takes the last wear step of a run, so that its figures are those of all its wear. To be called after
/// the last time step; the loads and measures of that step are then gone. Does nothing if the bit does not
/// wear.
void wear_at_end(const Case& c, Simulation& s);

/// Adds the wear of a step that was just made to the window, from WearPlan::from on. `c`: the case with the worn bit.
void measure_wear(const Case& c, const Move& move, State& state, Work& work);

}  // namespace tdbd::simulation

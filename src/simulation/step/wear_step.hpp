#pragma once

#include <optional>

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The pieces that wear: cutters, and teeth and gage pads that have a law.
std::vector<bit::WearSolid> solids_of(const Case& c);

/// The initial wear of the bit of a case. Nothing if the bit does not wear.
std::optional<WearState> start_wear(const Case& c);

/// Data of a wearing bit that is not part of its state. It can be recomputed from the state and the
/// case, whose bit is not worn. Nothing if the bit does not wear.
std::optional<WearWork> wear_work(const Case& c, const State& state);

/// Performs a wear step if one is due, that is, if the window has the length given in the case, or
/// if a flat might otherwise grow by more than WearPlan::largest_growth by the end of the next time
/// step. The parts of worn cutters are cut from those of the case and the bit is prepared again. In
/// free motion, the motion continues with the worn mass and unchanged velocities of the points of
/// the bit. The worn bit is contained in the previous one, so no contact is created. Throws
/// WearEnd; the simulation is then unchanged.
void wear_if_due(const Case& c, Simulation& s);

/// Performs the last wear step of a run, so that the statistics include all wear. Call it after the
/// last time step; the loads and measurements of that step are then lost. No effect if the bit does
/// not wear.
void wear_at_end(const Case& c, Simulation& s);

/// Adds the wear of the completed step to the window, starting at WearPlan::from. `c` is the case
/// with the worn bit.
void measure_wear(const Case& c, const Move& move, State& state, Work& work);

}  // namespace tdbd::simulation

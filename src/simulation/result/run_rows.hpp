#pragma once

#include <vector>

#include "simulation/result/chain_record.hpp"
#include "simulation/result/history.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// What the history of a run has: its parts, what else, and what a row stands for.
std::vector<HistoryPart> history_parts(const bit::Bit& bit);
HistoryExtent history_extent(const Case& c);
Rows rows_of(const Case& c);

/// The chain of a run whose string is one, and the motion of the bit at its end.
ChainView chain_view(const Case& c, const Simulation& s);

/// Takes the step just made into the history.
void take_step(const Case& of_run, const Simulation& s, History& history);

}  // namespace tdbd::simulation

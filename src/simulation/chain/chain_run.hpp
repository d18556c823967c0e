#pragma once

#include <string>

#include "simulation/chain/chain_simulation.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::simulation {

/// Result of a run of a chain.
struct ChainOutcome {
  RunStatus status = RunStatus::completed;
  ChainSimulation end;
};

/// Computes statics and modes, runs the steps of the case, if any, and writes the result folder.
/// The summary is written last: a folder without it contains no completed run. After an
/// interruption, everything recorded so far is written. If a step or a write fails, failure.txt
/// contains the reason, and the error is rethrown. Throws InputError before anything is written,
/// RunError later.
ChainOutcome run_chain(const ChainCase& c, const RotateOptions& options);

/// The summary of a case so far, as JSON with units in its keys.
std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status);

}  // namespace tdbd::simulation

#pragma once

#include <string>

#include "simulation/chain/chain_simulation.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::simulation {

/// How a run of a chain ended.
struct ChainOutcome {
  RunStatus status = RunStatus::completed;
  ChainSimulation end;
};

/// Computes statics and modes, runs the steps of the case, if it has any, and writes its result
/// folder, the summary last: a folder without one holds no finished run. An interrupted run writes
/// everything that was recorded. If a step or a write fails, failure.txt says what happened, and the
/// error is passed on. Throws InputError before anything is written, RunError later.
ChainOutcome run_chain(const ChainCase& c, const RotateOptions& options);

/// The summary of a case so far, as JSON with units in its keys.
std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status);

}  // namespace tdbd::simulation

#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "simulation/case/case.hpp"
#include "simulation/result/output_folder.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// How a run is carried out.
struct RunOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                 ///< the results do not depend on it
  const std::atomic<bool>* interrupted = nullptr;  ///< set from outside: stop after this step
  /// Called after every step with the number of all steps.
  std::function<void(const Simulation&, long)> progress;
};

/// Drills a case and writes its result folder; the summary last, so that a folder without one holds
/// no finished run. An interruption ends the run after its step and writes everything that is
/// recorded, with status "interrupted". If a step or a write fails, the history and the surface so
/// far are kept as far as they can be written, failure.txt says what happened, and the error is
/// thrown on. Throws InputError before anything is written, RunError later.
RunSummary run(const Case& c, const RunOptions& options);

/// The figures of a simulation so far.
RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status);

}  // namespace tdbd::simulation

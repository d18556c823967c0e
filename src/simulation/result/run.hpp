#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "simulation/case/case.hpp"
#include "simulation/result/output_folder.hpp"
#include "simulation/result/stopped_run.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// How a run is carried out.
struct RunOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                 ///< the results do not depend on it
  const std::atomic<bool>* interrupted = nullptr;  ///< set from outside: stop after this step
  /// Called before the first step: from here on there is something to save, and `interrupted` is read.
  std::function<void()> started = {};
  /// Called after every step with the number of all steps.
  std::function<void(const Simulation&, long)> progress = {};
  /// Called with what a user should know and the run goes on after.
  std::function<void(const std::string&)> warn = {};
  /// Called before the first step with what the start shows to be doubtful.
  std::function<void(const CaseWarning&)> tell = {};
};

/// Drills a case and writes its result folder; the summary last, so that a folder without one holds
/// no finished run. An interruption ends the run after its step and writes everything that is
/// recorded, with status "interrupted". If a step or a write fails, the history and the surface so
/// far are kept as far as they can be written, failure.txt says what happened, and the error is
/// thrown on. Throws InputError before anything is written, RunError later.
RunSummary run(const Case& c, const RunOptions& options);

/// Goes on with a run that was stopped or killed: the case is that of the folder (read_stopped_case),
/// and every file of the result but timing.json comes out as if nothing had happened. From its
/// newest checkpoint, or, where it came to none, from the start. Throws like run, and InputError
/// for checkpoints of another case or version.
RunSummary resume_run(const Case& c, const RunOptions& options);

/// The case of a folder that a run was begun in. Throws like stopped_case.
Case read_stopped_case(const std::filesystem::path& folder);

/// The figures of a simulation so far.
RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status);

}  // namespace tdbd::simulation

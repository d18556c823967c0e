#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "simulation/result/output_folder.hpp"
#include "simulation/result/stopped_run.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

struct RotateOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  const std::atomic<bool>* interrupted = nullptr;  ///< set from outside: stop within 1024 steps
  /// Called before the first step: from here on there is something to save, and `interrupted` is read.
  std::function<void()> started = {};
  /// Called now and then with the steps done and all steps.
  std::function<void(long, long)> progress = {};
  /// Called with what a user should know and the run goes on after.
  std::function<void(const std::string&)> warn = {};
};

/// How a run ended.
struct RotateOutcome {
  RunStatus status = RunStatus::completed;
  RotateSimulation end;
};

/// What is called on the way.
struct RotateHooks {
  std::function<void()> row = [] {};    ///< at every step of the history, the first and last too
  std::function<void()> block = [] {};  ///< at most every 1024 steps, after the row
};

/// Runs a case in memory to its end or to an interruption. Appends the seconds that a step took,
/// block by block.
RunStatus rotate_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& options,
                       const RotateHooks& hooks, std::vector<double>& step_seconds);

/// Runs a case and writes its result folder, the summary last: a folder without one holds no
/// finished run. An interrupted run writes everything that was recorded and a checkpoint, with status "interrupted".
/// If a step or a write fails, the history up to the last good state is kept as far as it can be
/// written, failure.txt says what happened, and the error is passed on. Throws InputError before
/// anything is written, RunError later.
RotateOutcome rotate(const RotateCase& c, const RotateOptions& options);

/// Goes on with a rotation that was stopped or killed: the case is that of the folder
/// (read_stopped_rotate_case), and every file of the result but timing.json comes out as if nothing
/// had happened. From its newest checkpoint, or, where it came to none, from the start. Throws like
/// rotate, and InputError for checkpoints of another case or version.
RotateOutcome resume_rotate(const RotateCase& c, const RotateOptions& options);

/// The case of a folder that a rotation was begun in. Throws like stopped_case.
RotateCase read_stopped_rotate_case(const std::filesystem::path& folder);

}  // namespace tdbd::simulation

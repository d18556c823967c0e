#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "simulation/result/output_folder.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

struct RotateOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  const std::atomic<bool>* interrupted = nullptr;  ///< set from outside: stop within 1024 steps
  std::function<void(long, long)>
      progress;  ///< called now and then with the steps done and all steps
};

/// How a run ended.
struct RotateOutcome {
  RunStatus status = RunStatus::completed;
  RotateSimulation end;
};

/// Runs a case in memory to its end or to an interruption. Calls `row` at every step that belongs in
/// the history, the first and the last included, and appends the seconds that a step took, block by
/// block.
RunStatus rotate_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& options,
                       const std::function<void()>& row, std::vector<double>& step_seconds);

/// Runs a case and writes its result folder, the summary last: a folder without one holds no
/// finished run. An interrupted run writes everything that was recorded, with status "interrupted".
/// If a step or a write fails, the history up to the last good state is kept as far as it can be
/// written, failure.txt says what happened, and the error is passed on. Throws InputError before
/// anything is written, RunError later.
RotateOutcome rotate(const RotateCase& c, const RotateOptions& options);

}  // namespace tdbd::simulation

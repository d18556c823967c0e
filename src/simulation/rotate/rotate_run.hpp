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
  std::function<void(long, long)> progress;        ///< now and then, with steps done and in all
};

/// What came of a run.
struct RotateOutcome {
  RunStatus status = RunStatus::completed;
  RotateSimulation end;
};

/// Runs a case in memory up to its end or an interruption, calling `row` at every step that belongs
/// into the history (the first and the last too), and adds the seconds of the steps by blocks.
RunStatus rotate_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& options,
                       const std::function<void()>& row, std::vector<double>& step_seconds);

/// Runs a case and writes its result folder; the summary last, so that a folder without one holds
/// no finished run. An interruption writes everything that is recorded, with status "interrupted".
/// If a step or a write fails, the history with the last good state is kept as far as it can be
/// written, failure.txt says what happened, and the error goes on. Throws InputError before
/// anything is written, RunError later.
RotateOutcome rotate(const RotateCase& c, const RotateOptions& options);

}  // namespace tdbd::simulation

#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/result/summary.hpp"
#include "simulation/study/hole.hpp"
#include "simulation/study/state_variables.hpp"

namespace tdbd::simulation {

/// Options of a study.
struct ConvergenceOptions {
  int threads = 1;
  const std::atomic<bool>* interrupted = nullptr;
  /// Called repeatedly with the level (from 1), the steps done and the total number of steps.
  std::function<void(int, long, long)> progress;
};

/// Result of a case at one level.
struct LevelOutcome {
  RunStatus status = RunStatus::completed;
  double step = 0.0;  ///< s, as used
  long steps = 0;
  EndState end;
  std::optional<Hole> hole;  ///< for a drilling case
};

/// Runs a case in memory, either a rotate case or a run. `number` is that of the level, for the
/// progress. Throws InputError, RunError.
LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& options);

}  // namespace tdbd::simulation

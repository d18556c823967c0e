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

/// How a study is carried out.
struct ConvergenceOptions {
  int threads = 1;
  const std::atomic<bool>* interrupted = nullptr;
  /// Called now and then: level from 1, steps done, steps in all.
  std::function<void(int, long, long)> progress;
};

/// What a case came to at one level.
struct LevelOutcome {
  RunStatus status = RunStatus::completed;
  double step = 0.0;  ///< s, the one that was used
  long steps = 0;
  EndState end;
  std::optional<Hole> hole;  ///< of a drilling case
};

/// Runs a case in memory, a rotate case or a run; `number` is the level's, for the progress.
/// Throws InputError, RunError.
LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& options);

}  // namespace tdbd::simulation

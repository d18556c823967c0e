#pragma once

#include "simulation/study/convergence.hpp"

namespace tdbd::simulation {

/// One level of a study, as a summary.
struct LevelOutcome {
  RunStatus status = RunStatus::completed;
  double step = 0.0;  ///< s, the one that was used
  long steps = 0;
  std::string summary;
};

/// Runs a case in memory, a rotate case or a run; `number` is the level's, for the progress.
LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& options);

}  // namespace tdbd::simulation

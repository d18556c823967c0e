#include "simulation/rotate/rotate_run.hpp"

#include <algorithm>
#include <utility>

namespace tdbd::simulation {
namespace {

/// Steps between checks of the clock and of interruptions, and between progress reports.
constexpr long block_steps = 1024;

/// Returns the number of steps until the next multiple of `every`.
long steps_to_next(long every, long done) { return every - done % every; }

/// A rotation and its result folder, for run_case and resume_case.
struct RotateTask {
  using Case = RotateCase;
  using Options = RotateOptions;
  using Outcome = RotateOutcome;
  using Saved = RotateCheckpoint;
  using Written = RotateWritten;
  static constexpr ResultKind kind = ResultKind::rotate;

  static RotateSimulation start(const RotateCase& c) { return simulation::start(c); }
  static RotateSimulation resume(const RotateCase&, RotateCheckpoint saved) {
    return std::move(saved.simulation);
  }
  static RotateCheckpoint read(const std::filesystem::path& file, const RotateCase& c) {
    return read_rotate_checkpoint(file, c);
  }

  RotateTask(const RotateCase& of, RotateSimulation started, const OutputFolder& folder,
             const RotateOptions& o)
      : c(of), s(std::move(started)), steps(c, s), recorder(c, s, folder, o.warn) {}

  void announce(const RotateOptions&) const {}
  std::string summary(RunStatus status) const { return summary_json(c, s, status); }
  RotateOutcome outcome(RunStatus status) { return {status, std::move(s)}; }

  const RotateCase& c;
  RotateSimulation s;
  RotateSteps steps;
  RotateRecorder recorder;
};

}  // namespace

long RotateSteps::advance() {
  const long to_row = steps_to_next(c_.history_every, done());
  const long to_checkpoint =
      c_.checkpoint_every > 0 ? steps_to_next(c_.checkpoint_every, done()) : block_steps;
  const long steps = std::min({block_steps, to_row, to_checkpoint, all() - done()});
  simulation::advance(c_, s_, steps);
  return steps;
}

RotateOutcome rotate(const RotateCase& c, const RotateOptions& o) {
  return run_case<RotateTask>(c, o);
}

RotateOutcome resume_rotate(const RotateCase& c, const RotateOptions& o) {
  return resume_case<RotateTask>(c, o);
}

RotateCase read_stopped_rotate_case(const std::filesystem::path& folder) {
  return read_rotate_case(stopped_case(folder, Stopped::rotate).string(), {});
}

}  // namespace tdbd::simulation

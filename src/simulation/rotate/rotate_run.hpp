#pragma once

#include <filesystem>

#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// Options of a rotation. `progress` is called with the numbers of completed and of all steps.
using RotateOptions = OptionsOf<void(long, long)>;

/// The result of a rotation.
struct RotateOutcome {
  RunStatus status = RunStatus::completed;
  RotateSimulation end;
};

/// The steps of a rotate case, for run_loop. The arguments must outlive them.
class RotateSteps {
 public:
  RotateSteps(const RotateCase& c, RotateSimulation& s) : c_(c), s_(s) {}

  long done() const { return s_.steps_done; }
  long all() const { return c_.time.steps; }
  double time() const { return s_.rotating.state.time; }
  void prepare() {}
  /// Makes at most 1024 steps, up to the next row of the history or checkpoint.
  long advance();
  void finish() {}
  template <class Progress>
  void report(const Progress& progress) const {
    progress(done(), all());
  }

 private:
  const RotateCase& c_;
  RotateSimulation& s_;
};

/// Runs a case and writes its result folder. The summary is written last, so a folder without one
/// has no finished run. An interrupted run writes everything that was recorded and a checkpoint,
/// with status "interrupted". If a step or a write fails, the history up to the last good state is
/// kept as far as it can be written, the reason is written to failure.txt, and RunError is thrown.
/// Throws InputError before anything is written, RunError later.
RotateOutcome rotate(const RotateCase& c, const RotateOptions& options);

/// Resumes a rotation that was stopped or killed. The case must be that of the folder
/// (read_stopped_rotate_case). All files of the result except timing.json are bitwise identical to
/// those of an uninterrupted run. Throws like rotate, and InputError for checkpoints of another
/// case or version.
RotateOutcome resume_rotate(const RotateCase& c, const RotateOptions& options);

/// Returns the case with which the rotation in a folder was begun. Throws like stopped_case.
RotateCase read_stopped_rotate_case(const std::filesystem::path& folder);

/// Gives a rotation that was stopped, or that is complete, a later end, and returns its new case,
/// with which resume_rotate continues it. An interrupted rotation continues from its checkpoint. A
/// complete one has no checkpoint and is computed again from its start. The files of the result,
/// except timing.json, are then bitwise identical to those of an uninterrupted rotation of the
/// folder's case.toml with the same `overrides`: "time.duration=VALUE".
///
/// The newest checkpoint and case.toml are rewritten for the new case; the summary of the earlier
/// end is removed. `warn` is called if an older checkpoint has to be used. Throws InputError, before
/// anything is changed, for other keys, for an end before the last checkpoint or the earlier end,
/// and for a duration that would change the time step.
RotateCase extend_rotate(const std::filesystem::path& folder,
                         const std::vector<std::string>& overrides,
                         const CheckpointKeeper::Warn& warn);

}  // namespace tdbd::simulation

#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

// The loop over the steps of a case, in memory or into a result folder. All commands share it. Each
// command provides these classes:
//
//   Steps     done(), all(): numbers of steps; time(): s; prepare(): is not timed; advance():
//             makes steps and returns their number; finish(): after the last; report(progress)
//   Recorder  begin(): before the first step; record(): after each advance; restore(written):
//             before any run; close(status); keep_so_far(exception): after a failure
//   Task      owns Steps and Recorder and defines how they are made, with members named like those
//             of DrillingTask

namespace tdbd::simulation {

/// Options of a run.
template <class Progress>
struct OptionsOf {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  int threads = 1;  ///< the results do not depend on it
  /// Set by another thread or a signal handler: stops after the current step (tdbd run), or within
  /// 1024 steps (others).
  const std::atomic<bool>* interrupted = nullptr;
  /// Called before the first step, when there is something to save. From then on `interrupted` is
  /// read.
  std::function<void()> started = {};
  /// Called repeatedly during the run.
  std::function<Progress> progress = {};
  /// Called with a warning for the user; the run continues.
  std::function<void(const std::string&)> warn = {};
  /// Called before the first step with doubtful properties of the start.
  std::function<void(const CaseWarning&)> tell = {};
};

/// For a run in memory.
struct NoRecorder {
  void begin() {}
  void record() {}
};

/// Runs until the end or an interruption. Appends the run time per step, in seconds, of each
/// advance to `step_seconds`.
template <class Steps, class Options, class Recorder>
RunStatus run_loop(Steps& steps, const Options& o, Recorder& recorder,
                   std::vector<double>& step_seconds) {
  constexpr std::size_t most_timed = 10'000'000;
  if (steps.done() == 0) recorder.begin();
  while (steps.done() < steps.all()) {
    if (o.interrupted && *o.interrupted) return RunStatus::interrupted;
    steps.prepare();
    const auto before = std::chrono::steady_clock::now();
    const long made = steps.advance();
    if (step_seconds.size() < most_timed)
      step_seconds.push_back(seconds_since(before) / static_cast<double>(made));
    recorder.record();
    if (o.progress) steps.report(o.progress);
  }
  steps.finish();
  return RunStatus::completed;
}

/// Runs in memory, without a recorder.
template <class Steps, class Options>
RunStatus run_loop(Steps& steps, const Options& o) {
  NoRecorder none;
  std::vector<double> step_seconds;
  return run_loop(steps, o, none, step_seconds);
}

/// Removes the checkpoints of a complete run, except the last one of a run that drills, which can
/// continue to a later end (extend_run).
void tidy(const OutputFolder& folder, ResultKind kind);

/// Runs a task and completes its result folder, the summary last. An interruption saves a
/// checkpoint. If a step or a write fails, the records so far are kept as far as they can be
/// written, the reason is written to failure.txt, and RunError is thrown.
template <class Task, class Options>
RunStatus complete(Task& task, const OutputFolder& folder, const Options& o) {
  const auto started = std::chrono::steady_clock::now();
  std::vector<double> step_seconds;
  RunStatus status = RunStatus::completed;
  if (o.started) o.started();
  try {
    status = run_loop(task.steps, o, task.recorder, step_seconds);
    task.recorder.close(status);
  } catch (const std::exception& e) {
    const std::string failure =
        failure_text(task.steps.done(), task.steps.all(), task.steps.time(), error_message_of(e));
    task.recorder.keep_so_far(e);
    ignore_failure([&] { write_text(folder.failure(), failure + "\n"); });
    throw RunError(failure);
  }
  const double wall = seconds_since(started);
  write_text(folder.timing(), to_json(timing_of(std::move(step_seconds), wall, o.threads)));
  write_text(folder.summary(), task.summary(status));
  if (status == RunStatus::completed) tidy(folder, Task::kind);
  return status;
}

/// Runs a case from its start into its result folder. Throws InputError before anything is written,
/// RunError later. A Task is constructed from the case, a simulation, the folder and the options;
/// Task::start(c) and Task::resume(c, saved) make the simulation, Task::read reads a saved one.
template <class Task>
typename Task::Outcome run_case(const typename Task::Case& c, const typename Task::Options& o) {
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files, Task::kind);
  auto s = Task::start(c);
  clear(folder, c.files, Task::kind);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  Task task(c, std::move(s), folder, o);
  task.announce(o);
  task.recorder.restore({});
  return task.outcome(complete(task, folder, o));
}

/// Resumes a case from the newest checkpoint of its folder or, if there is none, from the start.
/// Throws like run_case, and InputError for checkpoints of another case or version.
template <class Task>
typename Task::Outcome resume_case(const typename Task::Case& c, const typename Task::Options& o) {
  const OutputFolder folder{o.folder, std::make_shared<FolderLock>(o.folder)};
  std::optional<typename Task::Saved> saved;
  const auto read = [&](const std::filesystem::path& file) {
    return saved.emplace(Task::read(file, c)).steps_done();
  };
  read_newest_checkpoint(folder, read, o.warn);
  forget_end(folder);
  const auto written = saved ? saved->written : typename Task::Written{};
  Task task(c, saved ? Task::resume(c, std::move(*saved)) : Task::start(c), folder, o);
  task.recorder.restore(written);
  return task.outcome(complete(task, folder, o));
}

/// The command with which the run in a folder was begun.
enum class Stopped { run, rotate };

/// Returns the path of the case with which the run in a folder was begun. Throws InputError if
/// there is none, or if it belongs to another command, which the message names.
std::filesystem::path stopped_case(const std::filesystem::path& folder, Stopped command);

/// Returns whether the folder contains the result of a completed run. If so, calls `tidy`, because
/// older checkpoints remain if the process was killed just before it removed them.
bool tidy_if_finished(const std::filesystem::path& folder);

/// Options of a drilling run. `progress` is called after every step with the total number of steps.
using RunOptions = OptionsOf<void(const Simulation&, long)>;

/// The steps of a drilling case, for run_loop. The arguments must outlive them.
class DrillingSteps {
 public:
  /// `plan`: the step at which the order of the energy residual is observed; by default it is not.
  DrillingSteps(const Case& c, Simulation& s, const EnergyOrderPlan& plan = {});

  long done() const { return s_.state.steps_done; }
  long all() const { return c_.time.steps; }
  double time() const { return time_at(c_.time, done()); }
  void prepare();
  long advance();
  void finish();
  template <class Progress>
  void report(const Progress& progress) const {
    progress(s_, all());
  }

  EnergyOrder order;  ///< as far as it is observed

 private:
  const Case& c_;
  Simulation& s_;
  long observe_at_;
};

/// Drills a case and writes its result folder. The summary is written last, so a folder without one
/// has no finished run. An interruption ends the run after the current step and writes everything
/// that was recorded, with status "interrupted". If a step or a write fails, the history and the
/// surface so far are kept as far as they can be written, the reason is written to failure.txt, and
/// RunError is thrown. Throws InputError before anything is written, RunError later.
RunSummary run(const Case& c, const RunOptions& options);

/// Resumes a run that was stopped or killed. The case must be that of the folder
/// (read_stopped_case). All files of the result except timing.json are bitwise identical to those
/// of an uninterrupted run. Begins with the newest checkpoint or, if there is none, with the start.
/// Throws like run, and InputError for checkpoints of another case or version.
RunSummary resume_run(const Case& c, const RunOptions& options);

/// Returns the case with which the run in a folder was begun. Throws like stopped_case.
Case read_stopped_case(const std::filesystem::path& folder);

/// Resources that a run requires.
struct RunEstimate {
  double triangles = 0.0;     ///< of the rock at the end, including the new wall along the path
  double memory_bytes = 0.0;  ///< of the rock; the program itself needs about 30 MB more
  double disk_bytes = 0.0;    ///< of the result folder, checkpoints included
  double seconds = 0.0;       ///< on one thread of this machine
  long steps_tried = 0;       ///< number of steps from which the seconds were measured
};

/// Tries the first steps for some tenths of a second. `s`: the simulation at its start, which is
/// modified. The estimate of triangles and bytes is accurate within some tens of percent, that of
/// seconds within a factor of two, because the hole grows.
RunEstimate estimate(const Case& c, Simulation& s);

/// The settings that may change when a run is resumed.
inline constexpr std::array<std::string_view, 3> resumable_keys{"time.duration", "time.revolutions",
                                                                "output.means_from"};

/// Gives a run that was stopped, or that is complete, a later end, and returns its new case, with
/// which resume_run continues it. The files of the result are then bitwise identical to those of an
/// uninterrupted run of the folder's case.toml with the same `overrides`, except timing.json and,
/// in summary.json, the observed order of the energy residual: the plan of a longer run may place
/// it at a step that the run has already made.
///
/// `overrides`: "key=value" of resumable_keys. The newest checkpoint and case.toml are rewritten
/// for the new case; the summary of the earlier end is removed. If the run is killed in between,
/// the same call continues. `warn` is called if an older checkpoint has to be used.
///
/// Throws InputError, before anything is changed, for other keys; for an end before the last
/// checkpoint; for a complete run without a checkpoint (output.checkpoint_every = 0); and for a new
/// output.means_from that is earlier than the checkpoint, because statistics contain sums over
/// steps.
Case extend_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                const CheckpointKeeper::Warn& warn);

}  // namespace tdbd::simulation

#include "simulation/rotate/rotate_run.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/reason.hpp"
#include "core/whole_file.hpp"
#include "simulation/result/checkpoint_keeper.hpp"
#include "simulation/rotate/rotate_checkpoint.hpp"
#include "simulation/rotate/rotate_history.hpp"
#include "simulation/rotate/rotate_summary.hpp"

namespace tdbd::simulation {
namespace {

/// Steps between checks of the clock, of an interruption and of the progress.
constexpr long block_steps = 1024;

/// Only so many blocks are timed, one by one.
constexpr std::size_t timed_blocks = 1'000'000;

/// Steps until something is due that comes every so many.
long steps_to_next(long every, long done) { return every - done % every; }

/// Steps until the next row of the history, the next checkpoint that the case asks for, the end of
/// the block or the end of the run.
long next_block(const RotateCase& c, long done) {
  const long to_row = steps_to_next(c.history_every, done);
  const long to_checkpoint =
      c.checkpoint_every > 0 ? steps_to_next(c.checkpoint_every, done) : block_steps;
  return std::min({block_steps, to_row, to_checkpoint, c.time.steps - done});
}

/// What a rotation writes on its way.
struct RotateRecorder {
  OutputFolder folder;
  RotateHistory history;
  CheckpointKeeper keeper;
  std::vector<double> step_seconds;

  RotateRecorder(const RotateCase& c, const OutputFolder& f, const RotateOptions& o)
      : folder(f), history(f.history(), c), keeper(f, c.checkpoint_every, o.warn) {}
};

/// Puts the recorder where it was.
void go_on(const RotateWritten& written, RotateRecorder& r) {
  r.keeper.begin_rows(r.history.width(), written.rows);
  if (RowLog* rows = r.keeper.rows())
    rows->replay([&](std::span<const double> row) { r.history.append_again(row); });
  r.history.set_last_step(written.last_step);
}

void keep_checkpoint(const RotateCase& c, const RotateSimulation& s, RotateRecorder& r) {
  const RowLog* rows = r.keeper.rows();
  if (rows == nullptr) return;
  const RotateWritten written{rows->rows(), r.history.last_step()};
  r.keeper.keep(
      [&](const std::filesystem::path& file) { write_rotate_checkpoint(file, c, s, written); });
}

/// The row that an interruption adds is of no later run: no checkpoint counts it.
RunStatus loop(const RotateCase& c, RotateSimulation& s, const RotateOptions& o,
               RotateRecorder& r) {
  const auto row = [&] {
    if (r.history.append(c, s)) r.keeper.append(r.history.last_row());
  };
  const auto block = [&] {
    if (r.keeper.is_due(s.steps_done)) keep_checkpoint(c, s, r);
  };
  const RunStatus status = rotate_steps(c, s, o, {row, block}, r.step_seconds);
  if (status == RunStatus::interrupted) {
    keep_checkpoint(c, s, r);
    r.history.append(c, s);
  }
  r.history.close();
  return status;
}

void keep_so_far(const RotateCase& c, const RotateSimulation& s, const std::string& failure,
                 RotateRecorder& r) {
  ignore_failure([&] { r.history.append(c, s); });
  ignore_failure([&] { r.history.close(); });
  ignore_failure([&] { write_text(r.folder.failure(), failure + "\n"); });
}

RunStatus run_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& o,
                    RotateRecorder& r) {
  try {
    return loop(c, s, o, r);
  } catch (const std::exception& e) {
    const std::string failure =
        failure_text(s.steps_done, c.time.steps, s.rotating.state.time, reason_of(e));
    keep_so_far(c, s, failure, r);
    throw RunError(failure);
  }
}

/// Runs to the end and writes the figures, the summary last.
RotateOutcome finish(const RotateCase& c, RotateSimulation s, const RotateOptions& o,
                     RotateRecorder& r) {
  const auto started = std::chrono::steady_clock::now();
  if (o.started) o.started();
  RotateOutcome outcome{RunStatus::completed, std::move(s)};
  outcome.status = run_steps(c, outcome.end, o, r);
  const double wall = seconds_since(started);
  write_text(r.folder.timing(), to_json(timing_of(std::move(r.step_seconds), wall, 1)));
  write_text(r.folder.summary(), summary_json(c, outcome.end, outcome.status));
  if (outcome.status == RunStatus::completed) r.keeper.remove();
  return outcome;
}

/// The newest checkpoint, or the start where the folder has no file of one.
RotateCheckpoint newest_checkpoint(const OutputFolder& folder, const RotateCase& c,
                                   const CheckpointKeeper::Warn& warn) {
  RotateCheckpoint saved;
  const auto read = [&](const std::filesystem::path& file) {
    saved = read_rotate_checkpoint(file, c);
    return saved.simulation.steps_done;
  };
  if (!read_newest_checkpoint(folder, read, warn)) return {start(c), {}};
  return saved;
}

}  // namespace

RunStatus rotate_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& o,
                       const RotateHooks& hooks, std::vector<double>& step_seconds) {
  if (s.steps_done == 0) hooks.row();
  while (s.steps_done < c.time.steps) {
    if (o.interrupted && *o.interrupted) return RunStatus::interrupted;
    const long steps = next_block(c, s.steps_done);
    const auto before = std::chrono::steady_clock::now();
    advance(c, s, steps);
    if (step_seconds.size() < timed_blocks)
      step_seconds.push_back(seconds_since(before) / static_cast<double>(steps));
    if (s.steps_done % c.history_every == 0 || s.steps_done == c.time.steps) hooks.row();
    hooks.block();
    if (o.progress) o.progress(s.steps_done, c.time.steps);
  }
  return RunStatus::completed;
}

RotateOutcome rotate(const RotateCase& c, const RotateOptions& o) {
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files, ResultKind::rotate);
  RotateSimulation s = start(c);
  clear(folder, c.files, ResultKind::rotate);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  RotateRecorder recorder(c, folder, o);
  go_on({}, recorder);
  return finish(c, std::move(s), o, recorder);
}

RotateOutcome resume_rotate(const RotateCase& c, const RotateOptions& o) {
  const OutputFolder folder{o.folder, std::make_shared<FolderLock>(o.folder)};
  RotateCheckpoint saved = newest_checkpoint(folder, c, o.warn);
  forget_end(folder);
  RotateRecorder recorder(c, folder, o);
  go_on(saved.written, recorder);
  return finish(c, std::move(saved.simulation), o, recorder);
}

RotateCase read_stopped_rotate_case(const std::filesystem::path& folder) {
  return read_rotate_case(stopped_case(folder, Stopped::rotate).string(), {});
}

}  // namespace tdbd::simulation

#include "simulation/rotate/rotate_run.hpp"

#include <algorithm>
#include <chrono>

#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "simulation/rotate/rotate_history.hpp"
#include "simulation/rotate/rotate_summary.hpp"

namespace tdbd::simulation {
namespace {

/// Steps between checks of the clock, of an interruption and of the progress.
constexpr long block_steps = 1024;

/// Only so many blocks are timed, one by one.
constexpr std::size_t timed_blocks = 1'000'000;

/// Steps until the next row of the history, the end of the block or the end of the run.
long next_block(const RotateCase& c, long done) {
  const long to_row = c.history_every - done % c.history_every;
  return std::min({block_steps, to_row, c.time.steps - done});
}

void keep(const RotateCase& c, const RotateSimulation& s, const std::string& failure,
          const OutputFolder& folder, RotateHistory& history) {
  ignore_failure([&] { history.append(c, s); });
  ignore_failure([&] { history.close(); });
  ignore_failure([&] { write_text(folder.failure(), failure + "\n"); });
}

}  // namespace

RunStatus rotate_steps(const RotateCase& c, RotateSimulation& s, const RotateOptions& o,
                       const std::function<void()>& row, std::vector<double>& step_seconds) {
  row();
  while (s.steps_done < c.time.steps) {
    if (o.interrupted && *o.interrupted) {
      row();
      return RunStatus::interrupted;
    }
    const long steps = next_block(c, s.steps_done);
    const auto before = std::chrono::steady_clock::now();
    advance(c, s, steps);
    if (step_seconds.size() < timed_blocks)
      step_seconds.push_back(seconds_since(before) / static_cast<double>(steps));
    if (s.steps_done % c.history_every == 0 || s.steps_done == c.time.steps) row();
    if (o.progress) o.progress(s.steps_done, c.time.steps);
  }
  return RunStatus::completed;
}

RotateOutcome rotate(const RotateCase& c, const RotateOptions& o) {
  const auto started = std::chrono::steady_clock::now();
  RotateOutcome outcome{RunStatus::completed, start(c)};
  const OutputFolder folder = prepare(o.folder, o.overwrite, c.files, ResultKind::rotate);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  RotateHistory history(folder.history(), c);
  std::vector<double> step_seconds;
  RotateSimulation& s = outcome.end;
  try {
    outcome.status = rotate_steps(
        c, s, o, [&] { history.append(c, s); }, step_seconds);
    history.close();
  } catch (const std::exception& e) {
    const std::string failure =
        failure_text(s.steps_done, c.time.steps, s.rotating.state.time, e.what());
    keep(c, s, failure, folder, history);
    throw RunError(failure);
  }
  const double wall = seconds_since(started);
  write_text(folder.timing(), to_json(timing_of(std::move(step_seconds), wall, 1)));
  write_text(folder.summary(), summary_json(c, s, outcome.status));
  return outcome;
}

}  // namespace tdbd::simulation

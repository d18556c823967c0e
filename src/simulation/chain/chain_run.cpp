#include "simulation/chain/chain_run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/reason.hpp"
#include "core/whole_file.hpp"
#include "simulation/chain/chain_history.hpp"

namespace tdbd::simulation {
namespace {

/// Steps between checks of the clock, of an interruption and of the progress.
constexpr long longest_block = 1024;

long until_next(long every, long done) { return every - done % every; }

long next_steps(const ChainCase& c, long done) {
  const long profile =
      c.output.profile_every > 0 ? until_next(c.output.profile_every, done) : longest_block;
  return std::min({longest_block, until_next(c.history_every, done), profile, c.time.steps - done});
}

/// Runs to the end or to an interruption. Appends the run time per step in seconds, block by block.
RunStatus run_blocks(const ChainCase& c, const RotateOptions& o, ChainSimulation& s,
                     ChainHistory& history, std::vector<double>& seconds) {
  history.append(c, s);
  while (s.steps_done < c.time.steps) {
    if (o.interrupted && *o.interrupted) return RunStatus::interrupted;
    const long steps = next_steps(c, s.steps_done);
    const auto before = std::chrono::steady_clock::now();
    advance_chain(c, s, steps);
    if (seconds.size() < 1'000'000)
      seconds.push_back(seconds_since(before) / static_cast<double>(steps));
    history.append(c, s);
    if (o.progress) o.progress(s.steps_done, c.time.steps);
  }
  return RunStatus::completed;
}

}  // namespace

ChainOutcome run_chain(const ChainCase& c, const RotateOptions& o) {
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files, ResultKind::chain);
  ChainOutcome outcome{RunStatus::completed, start_chain(c)};
  clear(folder, c.files, ResultKind::chain);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  write_static_tables(folder.path, c);
  const auto started = std::chrono::steady_clock::now();
  std::vector<double> seconds;
  if (o.started) o.started();
  if (c.time.steps > 0) {
    ChainHistory history(folder.path, c);
    try {
      outcome.status = run_blocks(c, o, outcome.end, history, seconds);
      history.close();
    } catch (const std::exception& e) {
      const std::string failure =
          failure_text(outcome.end.steps_done, c.time.steps, outcome.end.time, reason_of(e));
      ignore_failure([&] { history.close(); });
      ignore_failure([&] { write_text(folder.failure(), failure + "\n"); });
      throw RunError(failure);
    }
    const double wall = seconds_since(started);
    write_text(folder.timing(), to_json(timing_of(std::move(seconds), wall, 1)));
  }
  write_text(folder.summary(), summary_json(c, outcome.end, outcome.status));
  return outcome;
}

}  // namespace tdbd::simulation

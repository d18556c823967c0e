#include "simulation/chain/chain_run.hpp"

#include <algorithm>
#include <string>

#include "io/whole_file.hpp"
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

/// The steps of a chain, for run_loop.
class ChainSteps {
 public:
  ChainSteps(const ChainCase& c, ChainSimulation& s) : c_(c), s_(s) {}

  long done() const { return s_.steps_done; }
  long all() const { return c_.time.steps; }
  double time() const { return s_.time; }
  void prepare() {}
  long advance() {
    const long steps = next_steps(c_, done());
    advance_chain(c_, s_, steps);
    return steps;
  }
  void finish() {}
  template <class Progress>
  void report(const Progress& progress) const {
    progress(done(), all());
  }

 private:
  const ChainCase& c_;
  ChainSimulation& s_;
};

class ChainRecorder {
 public:
  ChainRecorder(const ChainCase& c, const ChainSimulation& s, const OutputFolder& folder)
      : c_(c), s_(s), history_(folder.path, c) {}

  void begin() { record(); }
  void record() { history_.append(c_, s_); }
  void close(RunStatus) { history_.close(); }
  void keep_so_far(const std::exception&) {
    ignore_failure([&] { history_.close(); });
  }

 private:
  const ChainCase& c_;
  const ChainSimulation& s_;
  ChainHistory history_;
};

struct ChainTask {
  ChainTask(const ChainCase& of, ChainSimulation& started, const OutputFolder& folder)
      : c(of), s(started), steps(c, s), recorder(c, s, folder) {}

  std::string summary(RunStatus status) const { return summary_json(c, s, status); }

  const ChainCase& c;
  ChainSimulation& s;
  ChainSteps steps;
  ChainRecorder recorder;
};

}  // namespace

ChainOutcome run_chain(const ChainCase& c, const RotateOptions& o) {
  const OutputFolder folder = claim(o.folder, o.overwrite, c.files, ResultKind::chain);
  ChainOutcome outcome{RunStatus::completed, start_chain(c)};
  clear(folder, c.files, ResultKind::chain);
  write_text(folder.path / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  write_static_tables(folder.path, c);
  if (c.time.steps > 0) {
    ChainTask task(c, outcome.end, folder);
    outcome.status = complete(task, folder, o);
  } else {
    if (o.started) o.started();
    write_text(folder.summary(), summary_json(c, outcome.end, outcome.status));
  }
  return outcome;
}

}  // namespace tdbd::simulation

#include "simulation/rotate/rotate_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/output_folder.hpp"
#include "io/whole_file.hpp"

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

namespace {

namespace fs = std::filesystem;

constexpr std::string_view end_key = "time.duration";

void require_end_only(const fs::path& folder, const std::vector<std::string>& overrides) {
  for (const std::string& o : overrides)
    if (const std::string_view key = trimmed(std::string_view(o).substr(0, o.find('=')));
        key != end_key)
      throw InputError(fmt::format(
          "--set: found {} for a rotation that is resumed, expected {}; its other settings are "
          "those of {}",
          key, end_key, (folder / "case.toml").string()));
}

/// `least`: completed steps, of which a complete rotation has all.
void require_later_end(const RotateCase& longer, const RotateCase& before, long least) {
  if (longer.time.step == before.time.step && longer.time.steps >= least &&
      (longer.time.steps > least || least < before.time.steps))
    return;
  throw InputError(
      fmt::format("--set: {}: found {:.6g} s, expected a whole number of steps of {:.6g} s and an "
                  "end after the "
                  "{:.6g} s that the rotation has made",
                  end_key, longer.time.duration, before.time.step,
                  before.time.step * static_cast<double>(least)));
}

}  // namespace

RotateCase extend_rotate(const fs::path& path, const std::vector<std::string>& overrides,
                         const CheckpointKeeper::Warn& warn) {
  require_end_only(path, overrides);
  const fs::path file = stopped_case(path, Stopped::rotate);
  const RotateCase before = read_rotate_case(file.string(), {});
  RotateCase longer = read_rotate_case(file.string(), overrides);
  const OutputFolder folder{path, std::make_shared<FolderLock>(path)};
  std::optional<RotateCheckpoint> saved;
  // If the program was killed in this function, the checkpoint belongs to the new case already.
  const auto read = [&](const fs::path& checkpoint) {
    try {
      saved = read_rotate_checkpoint(checkpoint, longer);
    } catch (const InputError&) {
      saved = read_rotate_checkpoint(checkpoint, before);
    }
    return saved->steps_done();
  };
  const bool is_complete = tidy_if_finished(path);
  if (!is_complete) read_newest_checkpoint(folder, read, warn);
  require_later_end(longer, before,
                    is_complete ? before.time.steps
                    : saved     ? saved->steps_done()
                                : 0);
  if (saved) {
    write_rotate_checkpoint(folder.new_checkpoint(), longer, saved->simulation, saved->written);
    fs::rename(folder.new_checkpoint(), folder.checkpoint());
  }
  write_text(file, std::string(resolved_head) + "\n" + longer.resolved);
  forget_end(folder);
  return longer;
}

}  // namespace tdbd::simulation

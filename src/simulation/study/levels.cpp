#include "simulation/study/levels.hpp"

#include "core/parallel.hpp"
#include "simulation/case/case.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_record.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::simulation {
namespace {

constexpr const char* this_level = "the level's summary";

LevelOutcome rotate_level(const std::string& file, const std::vector<std::string>& overrides,
                          int number, const ConvergenceOptions& o) {
  const RotateCase c = read_rotate_case(file, overrides);
  RotateOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](long done, long total) { o.progress(number, done, total); };
  RotateSimulation s = start(c);
  RotateSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  return {status,
          c.time.step,
          s.steps_done,
          read_end_state(summary_json(c, s, status), this_level),
          {}};
}

LevelOutcome drill_level(const std::string& file, const std::vector<std::string>& overrides,
                         int number, const ConvergenceOptions& o) {
  const Case c = read_case(file, overrides);
  const ThreadLimit limit(o.threads);
  RunOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](const Simulation& so_far, long total) {
      o.progress(number, so_far.state.steps_done, total);
    };
  Simulation s = start(c);
  DrillingSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  LevelOutcome level{status, c.time.step, s.state.steps_done,
                     read_end_state(to_json(summary_of(c, s, status)), this_level),
                     hole_of(s.state.rock)};
  if (s.state.drive) add_motion(s.state.drive->state, level.end);
  return level;
}

}  // namespace

LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& o) {
  return is_rotate_case(case_file) ? rotate_level(case_file, overrides, number, o)
                                   : drill_level(case_file, overrides, number, o);
}

}  // namespace tdbd::simulation

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::app {
namespace {

void print_outcome(const simulation::RotateOutcome& o, const std::string& folder) {
  const simulation::Invariants& v = o.end.invariants;
  say("{}: {} steps to t = {:.6g} s, {} torque evaluations\n",
      o.status == simulation::RunStatus::completed ? "done" : "interrupted", o.end.steps_done,
      o.end.rotating.state.time, o.end.rotating.evaluations);
  say("largest changes: energy {:.2e} of its scale, momentum in space {:.2e} N m s, its vertical "
      "component {:.2e} N m s\n",
      v.energy_drift / v.energy_scale, std::sqrt(v.momentum_drift_squared), v.vertical_drift);
  say("results in {}\n", folder);
  if (o.status == simulation::RunStatus::interrupted)
    say("to resume: tdbd rotate --resume {}\n", folder);
}

/// Rotates with progress and a summary, unless `quiet` is set.
template <class Rotate>
int show(const ResultArguments& a, Rotate&& rotate) {
  auto options = options_for<simulation::RotateOptions>(a);
  Progress progress;
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "");
    };
  const simulation::RotateOutcome outcome = rotate(options);
  if (!a.quiet) {
    progress.finish();
    print_outcome(outcome, options.folder.string());
  }
  return outcome.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

int rotate(const ResultArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::rotation});
  const simulation::RotateCase c = simulation::read_rotate_case(a.case_file, a.overrides);
  return show(a, [&](const simulation::RotateOptions& o) { return simulation::rotate(c, o); });
}

int resume(const ResultArguments& a) {
  const simulation::RotateCase c = simulation::read_stopped_rotate_case(a.resumed);
  return show(a,
              [&](const simulation::RotateOptions& o) { return simulation::resume_rotate(c, o); });
}

}  // namespace

void add_rotate(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("rotate", "Integrate the rotation of a body with or without cones");
  auto a = std::make_shared<ResultArguments>();
  const ResultHelp help{.case_file = "the case file (TOML) with a table [body]",
                        .set = "--set time.step='5 ms'"};
  add_case(*command, *a, help);
  add_result_options(*command, *a, help);
  add_resume(*command, *a);
  command->footer(
      "Writes summary.json, history.nc, history.csv, timing.json and the resolved case.toml.\n"
      "The keys of a case: tdbd keys.\n"
      "Ctrl-C ends the run and writes what was recorded; exit code 130. A second Ctrl-C ends it "
      "immediately.\n"
      "With --resume an interrupted run continues; its results equal those of an uninterrupted "
      "run.\n"
      "Example: tdbd rotate cases/slow-top.toml -o out/top --set integrator.order=4");
  command->callback([a, &exit_code] {
    exit_code = guarded([&] {
      return begin_or_resume(
          *a, [&] { return rotate(*a); }, [&] { return resume(*a); });
    });
  });
}

}  // namespace tdbd::app

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/chain/chain_run.hpp"

namespace tdbd::app {
namespace {

void print_statics(const simulation::ChainCase& c) {
  for (const simulation::StaticLoad& l : simulation::static_loads(c.plan))
    say("{:<10} hook load {:9.3f} kN, surface torque {:8.4f} kN m\n", l.name,
        1e-3 * l.load.surface.hook_load, 1e-3 * l.load.surface.torque);
}

void print_run(const simulation::ChainCase& c, const simulation::ChainOutcome& o) {
  const simulation::ChainFigures& f = o.end.figures;
  say("{}: {} steps of {:.3g} s, {} elements of {:.4g} m, energy residual {:.2e} J\n",
      o.status == simulation::RunStatus::completed ? "done" : "interrupted", o.end.steps_done,
      c.time.step, c.plan.chain.count(), c.plan.chain.elements.length, f.residual);
  say("bit in the second half: {:.4g} to {:.4g} rad/s\n", f.least_speed, f.largest_speed);
}

int run_string(const ResultArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::string});
  const simulation::ChainCase c = simulation::read_chain_case(a.case_file, a.overrides);
  auto options = options_for<simulation::RotateOptions>(a);
  Progress progress;
  if (!a.quiet) {
    print_warnings(c.warnings);
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "");
    };
  }
  const simulation::ChainOutcome outcome = simulation::run_chain(c, options);
  if (!a.quiet) {
    progress.finish();
    print_statics(c);
    if (c.time.steps > 0) print_run(c, outcome);
    say("results in {}\n", options.folder.string());
  }
  return outcome.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

}  // namespace

void add_string(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "string", "Compute a drill string without rock: torque and drag, vibrations, runs");
  auto a = std::make_shared<ResultArguments>();
  const ResultHelp help{.case_file = "the case file (TOML) with [[string.sections]] and no [bit]"};
  add_case(*command, *a, help);
  add_result_options(*command, *a, help);
  command->footer(
      "Writes summary.json, static.csv (torque and drag over depth), broomstick.csv (hook loads "
      "while it is run in)\n"
      "and modes.csv (shapes of free vibrations).\n"
      "With the table [time] it runs the string off bottom or on the simple bit of [string.bit], "
      "and writes history.nc, history.csv,\n"
      "timing.json and, with output.string_profile_every, string.nc.\n"
      "The keys of a case: tdbd keys string.\n"
      "Ctrl-C ends the run and writes what was recorded; exit code 130. A second Ctrl-C ends it "
      "immediately.\n"
      "Example: tdbd string cases/string-build-and-hold.toml -o out/well --set "
      "string.friction.static=0.3");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return run_string(*a); }); });
}

}  // namespace tdbd::app

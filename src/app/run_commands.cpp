#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/result/run.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::app {
namespace {

using simulation::counted;

struct RunArguments : ResultArguments {
  int threads = 1;
  bool field_units = false;
};

/// "done" or "interrupted".
const char* status_word(simulation::RunStatus status) {
  return status == simulation::RunStatus::completed ? "done" : "interrupted";
}

/// What is saved of an interrupted run of `command`, after so many of its steps, and how to resume
/// it.
void print_interruption(const char* command, const std::string& folder, long done, long all) {
  const bool has_checkpoint = std::filesystem::exists(OutputFolder{folder}.checkpoint());
  print_out("saved: the results so far, {}\n",
            has_checkpoint ? fmt::format("and a checkpoint; {} of {} steps are done", done, all)
                           : "but no checkpoint: the resumed run begins at its start");
  print_out("to resume: tdbd {} --resume {}\n", command, folder);
}

/// An end twice as late, for a run whose means drift.
void print_longer_run(const simulation::RunSummary& s, const simulation::Case& c,
                      const std::string& folder) {
  if (s.status != simulation::RunStatus::completed || s.steady.is_steady.value_or(true)) return;
  print_out("to run longer: tdbd run --resume {} --set time.duration='{:.4g} s'\n", folder,
            2.0 * simulation::time_at(c.time, c.time.steps));
}

void print_summary(const simulation::RunSummary& s, const simulation::Case& c,
                   const std::string& folder, simulation::AnswerUnits units) {
  print_out("{}: {}, {:.3f} revolutions, {} removed, volumes balance to {:.1e}\n",
            status_word(s.status), counted(std::to_string(s.steps), "step"), s.revolutions,
            simulation::volume_text(s.removed_volume, units), s.volume_ledger_defect);
  for (const std::string& line : simulation::answer_lines(s, units)) print_out("{}\n", line);
  for (const simulation::ConeSummary& cone : s.cones)
    print_out(
        "{}: {:.4f} of the bit's speed (steps {:.4f} to {:.4f}, std {:.4f}); pure rolling of the "
        "gage row: {:.4f}, net slip {:+.2f} %\n",
        cone.name, cone.mean_speed_ratio, cone.min_speed_ratio, cone.max_speed_ratio,
        cone.std_speed_ratio, cone.rolling_ratio_gage_row, 100.0 * cone.net_slip_gage_row);
  print_out("results in {}\n", folder);
  if (s.status == simulation::RunStatus::interrupted)
    print_interruption("run", folder, c.time.first + s.steps, c.time.steps);
  print_longer_run(s, c, folder);
  if (c.output.frames_every > 0) print_out("to view it: tdbd page {}\n", folder);
}

std::string detail_of(const simulation::Simulation& s) {
  return fmt::format("  {} triangles  {:.3f} cm3", s.state.rock.surface.triangle_count(),
                     1e6 * s.state.ledger.removed.value());
}

/// Drills with warnings and, unless `quiet` is set, progress and a summary.
template <class Drill>
int show(const RunArguments& a, const simulation::Case& c, simulation::RunOptions options,
         Drill&& drill) {
  Progress progress;
  options.threads = a.threads;
  options.tell = [](const simulation::CaseWarning& w) { print_warnings({w}); };
  if (!a.quiet)
    options.progress = [&](const simulation::Simulation& s, long total) {
      if (progress.is_due(s.state.steps_done, total))
        progress.show(s.state.steps_done, total, detail_of(s));
    };
  const simulation::RunSummary summary = drill(options);
  if (!a.quiet) progress.finish();
  print_warnings(summary.found_at_end);
  if (!a.quiet)
    print_summary(summary, c, options.folder.string(),
                  a.field_units ? simulation::AnswerUnits::field : simulation::AnswerUnits::metric);
  return summary.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

int run(const RunArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::drilling});
  const simulation::Case c = simulation::read_case(a.case_file, a.overrides);
  print_warnings(c.warnings);
  return show(a, c, options_for<simulation::RunOptions>(a),
              [&](const simulation::RunOptions& o) { return simulation::run(c, o); });
}

int resume(const RunArguments& a) {
  const simulation::Case c = a.overrides.empty()
                                 ? simulation::read_stopped_case(a.resumed)
                                 : simulation::extend_run(a.resumed, a.overrides, print_warning);
  return show(a, c, options_for<simulation::RunOptions>(a),
              [&](const simulation::RunOptions& o) { return simulation::resume_run(c, o); });
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("run", "Run a drilling case");
  auto a = std::make_shared<RunArguments>();
  const ResultHelp help{.case_file = "the case file (TOML)"};
  add_case(*command, *a, help);
  add_result_options(*command, *a, help);
  add_threads(*command, a->threads);
  command->add_flag("--field-units", a->field_units,
                    "print the answer in lbf, ft lbf, ft/h, psi and in; files stay in SI");
  add_resume(*command, *a);
  command->footer(
      "The keys of a case: tdbd keys.\n"
      "With the table [wear] the cutters of a bit wear over hundreds of metres "
      "(cases/wear-bit-b.toml).\n"
      "Ctrl-C ends the run after the current step and writes what was recorded; exit code 130.\n"
      "A second Ctrl-C ends it immediately.\n"
      "With --resume an interrupted run continues; its results equal those of an uninterrupted "
      "run.\n"
      "With --set time.duration='20 s' or time.revolutions=20 as well, it continues to that end, "
      "also if it is complete.\n"
      "Example: tdbd run cases/bit-b-steady.toml -o out/b --set time.revolutions=2");
  command->callback([a, &exit_code] {
    exit_code = guarded([&] {
      return begin_or_resume(
          *a, [&] { return run(*a); }, [&] { return resume(*a); });
    });
  });
}

namespace {

void print_outcome(const simulation::RotateCase& c, const simulation::RotateOutcome& o,
                   const std::string& folder) {
  const simulation::Invariants& v = o.end.invariants;
  print_out("{}: {} to t = {:.6g} s, {}\n", status_word(o.status),
            counted(std::to_string(o.end.steps_done), "step"), o.end.rotating.state.time,
            counted(std::to_string(o.end.rotating.evaluations), "torque evaluation"));
  for (const std::string& line : simulation::answer_lines(c, o.end)) print_out("{}\n", line);
  print_out(
      "largest changes: energy {:.2e} of its scale, {:.4g} J; momentum in space {:.2e} N m s, its "
      "vertical component {:.2e} N m s\n",
      v.energy_drift / v.energy_scale, v.energy_scale, std::sqrt(v.momentum_drift_squared),
      v.vertical_drift);
  print_out("results in {}\n", folder);
  if (o.status == simulation::RunStatus::interrupted)
    print_interruption("rotate", folder, o.end.steps_done, c.time.steps);
}

/// Rotates with warnings and, unless `quiet` is set, progress and a summary.
template <class Rotate>
int show(const ResultArguments& a, const simulation::RotateCase& c, Rotate&& rotate) {
  auto options = options_for<simulation::RotateOptions>(a);
  print_warnings(c.warnings);
  Progress progress;
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "");
    };
  const simulation::RotateOutcome outcome = rotate(options);
  if (!a.quiet) progress.finish();
  print_warnings(simulation::end_warnings(c, outcome.end));
  if (!a.quiet) print_outcome(c, outcome, options.folder.string());
  return outcome.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

int rotate(const ResultArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::rotation});
  const simulation::RotateCase c = simulation::read_rotate_case(a.case_file, a.overrides);
  return show(a, c, [&](const simulation::RotateOptions& o) { return simulation::rotate(c, o); });
}

int resume(const ResultArguments& a) {
  const simulation::RotateCase c =
      a.overrides.empty() ? simulation::read_stopped_rotate_case(a.resumed)
                          : simulation::extend_rotate(a.resumed, a.overrides, print_warning);
  return show(a, c,
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
      "With --set time.duration='20 s' as well, it ends then; a complete one is computed again "
      "from its start.\n"
      "Example: tdbd rotate cases/slow-top.toml -o out/top --set integrator.order=4");
  command->callback([a, &exit_code] {
    exit_code = guarded([&] {
      return begin_or_resume(
          *a, [&] { return rotate(*a); }, [&] { return resume(*a); });
    });
  });
}

namespace {

void print_statics(const simulation::ChainCase& c) {
  for (const simulation::StaticLoad& l : simulation::static_loads(c.plan))
    print_out("{:<10} hook load {:9.3f} kN, surface torque {:8.4f} kN m\n", l.name,
              1e-3 * l.load.surface.hook_load, 1e-3 * l.load.surface.torque);
}

void print_run(const simulation::ChainCase& c, const simulation::ChainOutcome& o) {
  const simulation::ChainFigures& f = o.end.figures;
  print_out("{}: {} of {:.3g} s, {} of {:.4g} m, energy residual {:.2e} J\n", status_word(o.status),
            counted(std::to_string(o.end.steps_done), "step"), c.time.step,
            counted(std::to_string(c.plan.chain.count()), "element"), c.plan.chain.elements.length,
            f.residual);
  print_out("bit in the second half: {:.4g} to {:.4g} rad/s\n", f.least_speed, f.largest_speed);
}

int run_string(const ResultArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::string});
  const simulation::ChainCase c = simulation::read_chain_case(a.case_file, a.overrides);
  auto options = options_for<simulation::RotateOptions>(a);
  Progress progress;
  print_warnings(c.warnings);
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "");
    };
  const simulation::ChainOutcome outcome = simulation::run_chain(c, options);
  if (!a.quiet) {
    progress.finish();
    print_statics(c);
    if (c.time.steps > 0) print_run(c, outcome);
    print_out("results in {}\n", options.folder.string());
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

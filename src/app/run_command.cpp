#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/result/run.hpp"

namespace tdbd::app {
namespace {

struct RunArguments : ResultArguments {
  int threads = 1;
};

void print_energy(const simulation::DriveFigures& d) {
  const dynamics::ResidualOrder& order = d.order.residual;
  say("energy: {:.1f} J from the top, residual {:.2e} J, its order {}\n", d.ledger.top,
      dynamics::residual(d.stored, d.ledger),
      order.order ? fmt::format("{:.3f} in the time step", *order.order)
                  : "not observed: " + order.reason);
}

void print_summary(const simulation::RunSummary& s, const std::string& folder, bool has_frames) {
  say("{}: {} steps, {:.3f} revolutions, {:.4f} cm3 removed, ledger defect {:.1e}\n",
      s.status == simulation::RunStatus::completed ? "done" : "interrupted", s.steps, s.revolutions,
      1e6 * s.removed_volume, s.volume_ledger_defect);
  for (const simulation::ConeFigures& c : s.cones)
    say("{}: {:.4f} of the bit's speed (steps {:.4f} to {:.4f}, std {:.4f}); its gage row rolls at "
        "{:.4f}: net slip {:+.2f} %\n",
        c.name, c.mean_speed_ratio, c.min_speed_ratio, c.max_speed_ratio, c.std_speed_ratio,
        c.rolling_ratio_gage_row, 100.0 * c.net_slip_gage_row);
  if (s.drive) print_energy(*s.drive);
  say("results in {}\n", folder);
  if (s.status == simulation::RunStatus::interrupted)
    say("to resume: tdbd run --resume {}\n", folder);
  if (has_frames) say("to view it: reports/page3d.py {}\n", folder);
}

std::string detail_of(const simulation::Simulation& s) {
  return fmt::format("  {} triangles  {:.3f} cm3", s.state.rock.surface.triangle_count(),
                     1e6 * s.state.ledger.removed.value());
}

/// Drills with progress and a summary, unless `quiet` is set.
template <class Drill>
int show(const RunArguments& a, const simulation::Case& c, simulation::RunOptions options,
         Drill&& drill) {
  Progress progress;
  options.threads = a.threads;
  if (!a.quiet) {
    options.tell = [](const simulation::CaseWarning& w) { print_warnings({w}); };
    options.progress = [&](const simulation::Simulation& s, long total) {
      if (progress.is_due(s.state.steps_done, total))
        progress.show(s.state.steps_done, total, detail_of(s));
    };
  }
  const simulation::RunSummary summary = drill(options);
  if (!a.quiet) {
    progress.finish();
    print_warnings(summary.found_at_end);
    print_summary(summary, options.folder.string(), c.output.frames_every > 0);
  }
  return summary.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

int run(const RunArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::drilling});
  const simulation::Case c = simulation::read_case(a.case_file, a.overrides);
  if (!a.quiet) print_warnings(c.warnings);
  return show(a, c, options_for<simulation::RunOptions>(a),
              [&](const simulation::RunOptions& o) { return simulation::run(c, o); });
}

int resume(const RunArguments& a) {
  const simulation::Case c = simulation::read_stopped_case(a.resumed);
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
  add_resume(*command, *a);
  command->footer(
      "The keys of a case: tdbd keys.\n"
      "With the table [wear] the cutters of a bit wear over hundreds of metres "
      "(cases/wear-bit-b.toml).\n"
      "Ctrl-C ends the run after the current step and writes what was recorded; exit code 130.\n"
      "A second Ctrl-C ends it immediately.\n"
      "With --resume an interrupted run continues; its results equal those of an uninterrupted "
      "run.\n"
      "Example: tdbd run cases/bit-b-steady.toml -o out/b --set time.revolutions=2");
  command->callback([a, &exit_code] {
    exit_code = guarded([&] {
      return begin_or_resume(
          *a, [&] { return run(*a); }, [&] { return resume(*a); });
    });
  });
}

}  // namespace tdbd::app

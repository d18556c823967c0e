#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "app/interrupts.hpp"
#include "app/progress.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::app {
namespace {

struct RotateArguments {
  std::string case_file, folder;
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
};

void print_outcome(const simulation::RotateOutcome& o, const std::string& folder) {
  const simulation::Invariants& v = o.end.invariants;
  fmt::print("{}: {} steps to t = {:.6g} s, {} torque evaluations\n",
             o.status == simulation::RunStatus::completed ? "done" : "interrupted",
             o.end.steps_done, o.end.rotating.state.time, o.end.rotating.evaluations);
  fmt::print(
      "largest changes: energy {:.2e} of its scale, momentum in space {:.2e} N m s, of it vertical "
      "{:.2e}\n",
      v.energy_drift / v.energy_scale, std::sqrt(v.momentum_drift_squared), v.vertical_drift);
  fmt::print("results in {}\n", folder);
}

simulation::RotateOptions options_of(const RotateArguments& a) {
  simulation::RotateOptions options;
  options.folder = a.folder.empty() ? std::filesystem::path("results") /
                                          std::filesystem::path(a.case_file).stem()
                                    : std::filesystem::path(a.folder);
  options.overwrite = a.force ? simulation::Overwrite::force : simulation::Overwrite::no;
  options.interrupted = &catch_interrupts();
  return options;
}

int rotate(const RotateArguments& a) {
  simulation::RotateOptions options = options_of(a);
  const simulation::RotateCase c = simulation::read_rotate_case(a.case_file, a.overrides);
  Progress progress;
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "");
    };
  const simulation::RotateOutcome outcome = simulation::rotate(c, options);
  if (!a.quiet) {
    progress.finish();
    print_outcome(outcome, options.folder.string());
  }
  return outcome.status == simulation::RunStatus::completed ? 0 : interrupted_code;
}

}  // namespace

void add_rotate(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("rotate", "Rotate a body with or without cones");
  auto a = std::make_shared<RotateArguments>();
  command->add_option("case", a->case_file, "the case file (TOML) with a table [body]")->required();
  command->add_option("-o,--output", a->folder, "result folder; default results/CASE");
  command->add_option("--set", a->overrides, "override a key: --set time.step='5 ms'")
      ->allow_extra_args(false);
  command->add_flag("--force", a->force, "replace the results in the folder");
  command->add_flag("--quiet", a->quiet, "no progress, no summary");
  command->footer(
      "Writes summary.json, history.nc, history.csv, timing.json and the resolved case.toml.\n"
      "Ctrl-C ends the run and writes all that is recorded; exit code 130.\n"
      "Example: tdbd rotate cases/slow-top.toml -o out/top --set integrator.order=4");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return rotate(*a); }); });
}

}  // namespace tdbd::app

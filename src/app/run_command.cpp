#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <filesystem>

#include "app/commands.hpp"
#include "app/progress.hpp"
#include "simulation/run.hpp"

namespace tdbd::app {
namespace {

std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted = true; }

struct Arguments {
  std::string case_file, folder;
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
};

void print_summary(const simulation::RunSummary& s, const std::string& folder) {
  fmt::print("{}: {} steps, {:.3f} revolutions, {:.4f} cm3 removed, ledger defect {:.1e}\n",
             s.status == simulation::RunStatus::completed ? "done" : "interrupted", s.steps,
             s.revolutions, 1e6 * s.removed_volume, s.volume_ledger_defect);
  fmt::print("results in {}\n", folder);
}

int run(const Arguments& a) {
  const simulation::Case c = simulation::read_case(a.case_file, a.overrides);
  simulation::RunOptions options;
  options.folder = a.folder.empty() ? std::filesystem::path("results") /
                                          std::filesystem::path(a.case_file).stem()
                                    : std::filesystem::path(a.folder);
  options.overwrite = a.force ? simulation::Overwrite::force : simulation::Overwrite::no;
  options.interrupted = &interrupted;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  Progress progress;
  if (!a.quiet)
    options.progress = [&](const simulation::Simulation& s, long total) {
      progress.show(s, total);
    };
  const simulation::RunSummary summary = simulation::run(c, options);
  if (a.quiet) return 0;
  progress.finish();
  print_summary(summary, options.folder.string());
  return 0;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("run", "Drill a case");
  auto a = std::make_shared<Arguments>();
  command->add_option("case", a->case_file, "the case file (TOML)")->required();
  command->add_option("-o,--output", a->folder, "result folder; default results/CASE");
  command->add_option("--set", a->overrides, "override a key: --set time.step='2 ms'")
      ->allow_extra_args(false);
  command->add_flag("--force", a->force, "replace the results in the folder");
  command->add_flag("--quiet", a->quiet, "no progress, no summary");
  command->footer("Example: tdbd run cases/bit-b-steady.toml -o out/b --set time.revolutions=2");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return run(*a); }); });
}

}  // namespace tdbd::app

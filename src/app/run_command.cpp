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

constexpr int interrupted_code = 130;  ///< 128 + SIGINT, as a shell would say it

std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted = true; }

/// Ctrl-C, a polite kill and a closed terminal end the run after its step.
void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_interrupt);
}

struct Arguments {
  std::string case_file, folder;
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
  int threads = 1;
};

void print_summary(const simulation::RunSummary& s, const std::string& folder) {
  fmt::print("{}: {} steps, {:.3f} revolutions, {:.4f} cm3 removed, ledger defect {:.1e}\n",
             s.status == simulation::RunStatus::completed ? "done" : "interrupted", s.steps,
             s.revolutions, 1e6 * s.removed_volume, s.volume_ledger_defect);
  fmt::print("results in {}\n", folder);
}

simulation::RunOptions options_of(const Arguments& a) {
  simulation::RunOptions options;
  options.folder = a.folder.empty() ? std::filesystem::path("results") /
                                          std::filesystem::path(a.case_file).stem()
                                    : std::filesystem::path(a.folder);
  options.overwrite = a.force ? simulation::Overwrite::force : simulation::Overwrite::no;
  options.threads = a.threads;
  options.interrupted = &interrupted;
  return options;
}

int run(const Arguments& a) {
  catch_interrupts();
  const simulation::Case c = simulation::read_case(a.case_file, a.overrides);
  simulation::RunOptions options = options_of(a);
  Progress progress;
  if (!a.quiet)
    options.progress = [&](const simulation::Simulation& s, long total) {
      progress.show(s, total);
    };
  const simulation::RunSummary summary = simulation::run(c, options);
  if (!a.quiet) {
    progress.finish();
    print_summary(summary, options.folder.string());
  }
  return summary.status == simulation::RunStatus::completed ? 0 : interrupted_code;
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
  command->add_option("--threads", a->threads, "threads; the results do not depend on them")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->footer(
      "Ctrl-C ends the run after its step and writes all that is recorded; exit code 130.\n"
      "Example: tdbd run cases/bit-b-steady.toml -o out/b --set time.revolutions=2");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return run(*a); }); });
}

}  // namespace tdbd::app

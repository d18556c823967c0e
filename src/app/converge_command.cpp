#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/study/convergence_output.hpp"
#include "simulation/study/convergence_run.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;
namespace sim = simulation;

struct ConvergeArguments : ResultArguments {
  sim::ConvergencePlan plan;  ///< case file and overrides are taken from ResultArguments
  std::string reference;
  int threads = 1;
};

sim::ConvergenceOptions convergence_options(const ConvergeArguments& a, Progress& progress) {
  sim::ConvergenceOptions options;
  options.threads = a.threads;
  options.interrupted = &save_on_interrupt();
  if (!a.quiet)
    options.progress = [&](int level, long done, long total) {
      if (progress.is_due(done, total))
        progress.show(done, total, fmt::format("  level {} of {}", level, a.plan.levels));
    };
  return options;
}

int converge(ConvergeArguments a) {
  Progress progress;
  const sim::ConvergenceOptions options = convergence_options(a, progress);
  a.plan.case_file = a.case_file;
  a.plan.overrides = a.overrides;
  if (!a.reference.empty()) a.plan.reference = sim::read_end_state_file(a.reference);
  simulation::require_kind(a.case_file, a.overrides,
                           {simulation::CaseKind::drilling, simulation::CaseKind::rotation});
  const fs::path folder = result_folder(a, "-convergence");
  const sim::Convergence c =
      sim::converge_into({folder, overwrite_of(a.force), a.reference}, a.plan, options);
  if (!a.quiet) {
    progress.finish();
    const std::string name = folder.string();
    say("{}results in {}; to draw them: reports/draw.py {}\n", sim::table_text(c), name, name);
  }
  return c.status == sim::RunStatus::completed ? 0 : interrupted_code;
}

void add_convergence_options(CLI::App& command, ConvergeArguments& a) {
  const ResultHelp help{.case_file = "the case file (TOML) of a drilling or a rotation",
                        .folder = "results/CASE-convergence",
                        .quiet = "no progress, no table"};
  add_case(command, a, help);
  command
      .add_option("--over", a.plan.keys,
                  "the quantity to refine: time.step; repeat it to refine several together")
      ->required()
      ->type_name("KEY")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command.add_option("--levels", a.plan.levels, "number of values; the first is that of the case")
      ->required()
      ->check(CLI::Range(sim::least_levels, sim::most_levels));
  command.add_option("--factor", a.plan.factor, "factor between successive values")
      ->capture_default_str();
  command
      .add_option("--reference", a.reference,
                  "compute errors relative to this result (folder or summary.json)")
      ->type_name(a_folder);
  add_result_options(command, a, help);
  add_threads(command, a.threads);
}

}  // namespace

void add_converge(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("converge", "Compute observed orders of convergence of a case");
  auto a = std::make_shared<ConvergeArguments>();
  add_convergence_options(*command, *a);
  command->footer(
      "Writes convergence.json and convergence.csv; reports/draw.py FOLDER draws them. An\n"
      "order needs at least three differences above rounding whose local orders have settled;\n"
      "otherwise the table gives the reason. The numerical uncertainty of the finest level\n"
      "follows ASME V&V 20. Surfaces of drilled holes are compared too.\n"
      "Example: tdbd converge cases/slow-top.toml --over time.step --levels 6 -o out/orders\n"
      "Both at once: tdbd converge cases/bit-b-steady.toml --over rock.edge_length \\\n"
      "  --over time.step --levels 5 --factor 1.4");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return converge(*a); }); });
}

}  // namespace tdbd::app

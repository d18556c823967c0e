#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

#include "app/commands.hpp"
#include "app/interrupts.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "simulation/result/output_folder.hpp"
#include "simulation/study/convergence_output.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;
using namespace simulation;

struct ConvergeArguments {
  ConvergencePlan plan;
  std::string folder, reference;
  bool force = false, quiet = false;
  int threads = 1;
};

fs::path folder_of(const ConvergeArguments& a) {
  if (!a.folder.empty()) return a.folder;
  return fs::path("results") / (fs::path(a.plan.case_file).stem().string() + "-convergence");
}

ConvergenceOptions options_of(const ConvergeArguments& a, Progress& progress) {
  ConvergenceOptions options;
  options.threads = a.threads;
  options.interrupted = &catch_interrupts();
  if (!a.quiet)
    options.progress = [&](int level, long done, long total) {
      if (progress.is_due(done, total))
        progress.show(done, total, fmt::format("  level {} of {}", level, a.plan.levels));
    };
  return options;
}

/// The reference is an input: a study must not replace it.
std::vector<std::string> inputs_of(const ConvergeArguments& a, const ConvergenceStart& start) {
  std::vector<std::string> inputs = start.files;
  if (!a.reference.empty())
    inputs.push_back(fs::is_directory(a.reference) ? fs::path(a.reference) / "summary.json"
                                                   : fs::path(a.reference));
  return inputs;
}

int converge(ConvergeArguments a) {
  Progress progress;
  const ConvergenceOptions options = options_of(a, progress);
  if (!a.reference.empty()) a.plan.reference = read_end_state_file(a.reference);
  const ConvergenceStart start = check(a.plan);
  const OutputFolder folder = prepare(folder_of(a), a.force ? Overwrite::force : Overwrite::no,
                                      inputs_of(a, start), HasFrames::no);
  try {
    const Convergence c = simulation::converge(a.plan, options);
    write_convergence(folder.path, c);
    if (!a.quiet) {
      progress.finish();
      const std::string name = folder.path.string();
      fmt::print("{}results in {}; to draw them: reports/draw.py {}\n", table_text(c), name, name);
    }
    return c.status == RunStatus::completed ? 0 : interrupted_code;
  } catch (const InputError&) {
    std::error_code ignored;
    fs::remove(folder.path, ignored);  // nothing is in it
    throw;
  } catch (const RunError& e) {
    write_text(folder.failure(), fmt::format("{}\n", e.what()));
    throw;
  }
}

void add_options(CLI::App& command, ConvergeArguments& a) {
  command.add_option("case", a.plan.case_file, "the case file (TOML), of a run or to rotate")
      ->required();
  command.add_option("--over", a.plan.key, "the quantity to divide: time.step")->required();
  command.add_option("--levels", a.plan.levels, "how many values, the case's own the first")
      ->required()
      ->check(CLI::Range(2, 60));
  command.add_option("--factor", a.plan.factor, "what the quantity is divided by")
      ->capture_default_str();
  command.add_option("--reference", a.reference,
                     "measure errors against this result (folder or summary.json)");
  command.add_option("-o,--output", a.folder, "result folder; default results/CASE-convergence");
  command.add_option("--set", a.plan.overrides, "override a key")->allow_extra_args(false);
  command.add_flag("--force", a.force, "replace the results in the folder");
  command.add_flag("--quiet", a.quiet, "no progress, no table");
  command.add_option("--threads", a.threads, "threads of a run; the results do not depend on them")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

}  // namespace

void add_converge(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("converge", "Observe orders of convergence of a case");
  auto a = std::make_shared<ConvergeArguments>();
  add_options(*command, *a);
  command->footer(
      "Writes convergence.json and convergence.csv; reports/draw.py FOLDER draws them. An\n"
      "order rests on at least three differences above rounding whose local orders have settled;\n"
      "else the table says why there is none.\n"
      "Example: tdbd converge cases/slow-top.toml --over time.step --levels 6 -o out/orders");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return converge(*a); }); });
}

}  // namespace tdbd::app

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "calibration/laboratory/laboratory.hpp"
#include "calibration/result/answer.hpp"
#include "core/error.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/study/convergence_output.hpp"
#include "sweep/sweep.hpp"

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
    print_out("{}results in {}; to draw them: tdbd draw {}\n", sim::table_text(c), name, name);
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
      "Writes convergence.json and convergence.csv; tdbd draw FOLDER draws them. An\n"
      "order needs at least three differences above rounding whose local orders have settled;\n"
      "otherwise the table gives the reason. The numerical uncertainty of the finest level\n"
      "follows ASME V&V 20. Surfaces of drilled holes are compared too.\n"
      "Example: tdbd converge cases/slow-top.toml --over time.step --levels 6 -o out/orders\n"
      "Both at once: tdbd converge cases/bit-b-steady.toml --over rock.edge_length \\\n"
      "  --over time.step --levels 5 --factor 1.4");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return converge(*a); }); });
}

namespace {

namespace fs = std::filesystem;

struct SweepArguments {
  std::string design, table, shard = "1/1";
  int threads = 1;
  bool force = false, quiet = false, points = false, figures = false;
};

/// Parses for example "3/8".
sweep::Shard shard_of(const std::string& text) {
  sweep::Shard s;
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, s.i);
  if (first == std::errc() && slash != end && *slash == '/') {
    const auto [rest, second] = std::from_chars(slash + 1, end, s.n);
    if (second == std::errc() && rest == end && s.i >= 1 && s.i <= s.n) return s;
  }
  throw InputError(fmt::format("--shard: found {}, expected I/N with 1 <= I <= N", text));
}

/// The output table. Rejects an existing file that was not written by a sweep, unless --force is
/// given.
fs::path table_path(const SweepArguments& a) {
  const fs::path table = a.table.empty()
                             ? fs::path("results") / fs::path(a.design).stem().concat(".nc")
                             : fs::path(a.table);
  if (table.extension() != ".nc")
    throw InputError(fmt::format("-o: found {}, expected a file NAME.nc", table.string()));
  const bool ours = fs::is_directory(sweep::points_folder(table));
  if (fs::exists(table) && !ours && !a.force)
    throw InputError(fmt::format(
        "-o: found {}, which no sweep wrote, expected a new file (or --force)", table.string()));
  return table;
}

int list_points(const sweep::Design& d) {
  const sweep::Points points = sweep::points_of(d);
  for (long i = 0; i < points.count; ++i)
    print_out("{}: {}\n", i, fmt::join(sweep::overrides_at(d, points, i), "; "));
  return 0;
}

int list_figures(const sweep::Design& d, const fs::path& table) {
  const sweep::Points points = sweep::points_of(d);
  const auto names = sweep::figures_on_offer(d, sweep::overrides_at(d, points, 0),
                                             sweep::points_folder(table) / "cuts");
  print_out("{}\n", fmt::join(names, "\n"));
  return 0;
}

std::string correlation_text(double rho) {
  return std::isfinite(rho) ? fmt::format("{:.2f}", rho) : "unknown (fewer than three values)";
}

/// Prints how well a filter follows the results.
void print_filter(const sweep::Design& d, const sweep::FilterReport& f) {
  if (f.unchanged_message.empty())
    print_out("unchanged case: {} {:.4g}, {} {:.4g}", f.figure, f.unchanged_figure, f.filter,
              f.unchanged_filter);
  else
    print_out("unchanged case: failed: {}", f.unchanged_message);
  if (f.best_point >= 0) {
    const std::vector<std::string> all = sweep::overrides_at(d, sweep::points_of(d), f.best_point);
    print_out("\nbest point, number {}: {} {:.4g}", f.best_point, f.figure, f.best_figure);
    for (std::size_t i = d.fixed.size(); i < all.size(); ++i) print_out("; {}", all[i]);
  }
  print_out(
      "\nrank correlation of {} and {}: {} for all {} points, {} for the {} that the filter "
      "finds best\n",
      f.filter, f.figure, correlation_text(f.of_all), f.points, correlation_text(f.of_best),
      f.best);
}

/// Prints the warnings of a sweep, also with --quiet.
void print_sweep_warnings(const sweep::SweepResult& r) {
  if (r.failed > 0)
    print_warning(fmt::format("{} of {} points failed, the first with: {}", r.failed, r.done,
                              r.first_failure));
  if (!r.written) return;
  if (r.filter && std::abs(r.filter->of_all) < sweep::weak_correlation)
    print_warning(fmt::format(
        "{} hardly follows {}: the filter may have rejected better points; raise filter.keep or "
        "filter.samples",
        r.filter->filter, r.filter->figure));
  if (r.without_values > 0)
    print_warning(fmt::format(
        "{} of {} points have a figure without a value (nan); a mean has none if the run ends "
        "before output.means_from",
        r.without_values, r.done));
  if (r.unsteady > 0)
    print_warning(
        fmt::format("the means of {} of {} points are not steady (column steady): run longer",
                    r.unsteady, r.done));
}

void print_result(const sweep::Design& d, const sweep::SweepResult& r, const fs::path& table) {
  if (!r.written)
    return print_out(
        "{} of {} points are done{}\n", r.done, r.points,
        r.interrupted ? "; repeat the command to continue" : "; the last shard writes the table");
  print_out("{} points done, {} of them by an earlier call{}\n", r.points, r.found,
            d.goals.empty() ? "" : fmt::format("; {} on the Pareto front", r.on_front));
  if (r.filter) print_filter(d, *r.filter);
  print_out("table in {}; to draw it: tdbd draw {}\n", table.string(), table.string());
}

int sweep_points(const SweepArguments& a) {
  const sweep::Shard shard = shard_of(a.shard);
  const fs::path table = table_path(a);
  simulation::require_kind(a.design, {}, {simulation::CaseKind::sweep});
  const sweep::Design d = sweep::read_design(a.design);
  if (a.points) return list_points(d);
  if (a.figures) return list_figures(d, table);
  Progress progress;
  sweep::SweepOptions options{table, shard, a.threads, &save_on_interrupt()};
  options.warn = print_warning;
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "  points");
    };
  const sweep::SweepResult r = sweep::run_sweep(d, options);
  if (!a.quiet) progress.finish();
  print_sweep_warnings(r);
  if (!a.quiet) print_result(d, r, table);
  return r.interrupted ? interrupted_code : 0;
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("sweep", "Run a design of many cases into one table");
  auto a = std::make_shared<SweepArguments>();
  command->add_option("design", a->design, "the design (TOML): case, factors, figures")
      ->required()
      ->type_name(a_toml_file);
  command->add_option("-o,--output", a->table, "the table, NAME.nc; default: results/DESIGN.nc")
      ->type_name("FILE.nc");
  command->add_option("--shard", a->shard, "compute every N-th point, starting with the I-th: I/N")
      ->capture_default_str();
  command->add_flag("--points", a->points, "print the settings of each point and run nothing");
  command->add_flag("--figures", a->figures,
                    "run the first point and print the names of all figures for a design");
  command->add_flag("--force", a->force, "replace a table that no sweep wrote");
  command->add_flag("--quiet", a->quiet, "no progress, no summary");
  add_threads(*command, a->threads);
  command->footer(
      "Completed points are stored in NAME.points: after an interruption the same command\n"
      "continues, and a larger design reuses them. Shards of one design may run at the same\n"
      "time with the same -o.\n"
      "Example: tdbd sweep cases/sweeps/rake-and-rate.toml --threads 2 -o out/rake.nc");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return sweep_points(*a); }); });
}

namespace {

struct CalibrateArguments : ResultArguments {
  std::string cuts;
  int threads = 1;
};

int calibrate(const CalibrateArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::calibration});
  const std::filesystem::path folder = result_folder(a);
  const auto c = calibration::read_calibration(a.case_file, a.overrides);
  Progress progress;
  calibration::CalibrateOptions options{folder, a.cuts, overwrite_of(a.force), a.threads, {}};
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "  cut runs");
      if (done == total) progress.finish();
    };
  const calibration::Calibration found = calibration::calibrate_into(c, options);
  for (const std::string& warning : found.warnings) print_warning(warning);
  if (!a.quiet) print_out("{}results in {}\n", calibration::answer_text(c, found), folder.string());
  return 0;
}

}  // namespace

void add_calibrate(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("calibrate", "Fit a force law to measured records");
  auto a = std::make_shared<CalibrateArguments>();
  const ResultHelp help{.case_file = "the calibration (TOML)",
                        .set = "--set noise.test=0.04",
                        .quiet = "no progress, no table"};
  add_case(*command, *a, help);
  add_result_options(*command, *a, help);
  command
      ->add_option("--cuts", a->cuts,
                   "folder that stores cut runs for reuse; default: cuts, next to the "
                   "result folder")
      ->type_name(a_folder);
  add_threads(*command, a->threads);
  command->footer(
      "The keys of a calibration: tdbd keys calibration.\n"
      "Example: tdbd calibrate validation/cases/lab-bc-a.toml -o out/bc-a");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return calibrate(*a); }); });
}

namespace {

struct LaboratoryArguments {
  std::string case_file, output, cuts;
  std::vector<std::string> overrides;
  bool force = false;
  int threads = 1;
};

int make_records(const LaboratoryArguments& a) {
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::laboratory});
  const auto c = calibration::read_laboratory(a.case_file, a.overrides);
  for (const std::string& doubt : c.setup.doubts) print_warning(doubt);
  calibration::write_records(c, {a.output, a.cuts, overwrite_of(a.force), a.threads, {}});
  return 0;
}

}  // namespace

void add_laboratory(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("laboratory", "Compute synthetic records of bits under a known force law");
  auto a = std::make_shared<LaboratoryArguments>();
  command->add_option("case", a->case_file, "the laboratory (TOML)")
      ->required()
      ->type_name(a_toml_file);
  command->add_option("-o,--output", a->output, "the records, csv")
      ->required()
      ->type_name("FILE.csv");
  command->add_option("--cuts", a->cuts, "folder of cut runs; default: cuts, next to the records")
      ->type_name(a_folder);
  add_set(*command, a->overrides, "override a key: --set laboratory.seed=7");
  command->add_flag("--force", a->force, "replace the file");
  add_threads(*command, a->threads);
  command->footer(
      "The keys: tdbd keys laboratory.\n"
      "Example: tdbd laboratory validation/cases/laboratory.toml -o out/lab.csv");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return make_records(*a); }); });
}

}  // namespace tdbd::app

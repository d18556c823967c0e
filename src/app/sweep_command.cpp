#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "simulation/case/case_kind.hpp"
#include "sweep/sweep.hpp"

namespace tdbd::app {
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
    say("{}: {}\n", i, fmt::join(sweep::overrides_at(d, points, i), "; "));
  return 0;
}

int list_figures(const sweep::Design& d, const fs::path& table) {
  const sweep::Points points = sweep::points_of(d);
  const auto names = sweep::figures_on_offer(d, sweep::overrides_at(d, points, 0),
                                             sweep::points_folder(table) / "cuts");
  say("{}\n", fmt::join(names, "\n"));
  return 0;
}

void print_result(const sweep::Design& d, const sweep::SweepResult& r, const fs::path& table) {
  if (r.failed > 0)
    print_warning(fmt::format("{} of {} points failed, the first with: {}", r.failed, r.done,
                              r.first_failure));
  if (!r.written)
    return say(
        "{} of {} points are done{}\n", r.done, r.points,
        r.interrupted ? "; repeat the command to continue" : "; the last shard writes the table");
  say("{} points done, {} of them before{}\ntable in {}; to draw it: reports/sweep.py {}\n",
      r.points, r.found, d.goals.empty() ? "" : fmt::format("; {} on the front", r.on_front),
      table.string(), table.string());
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
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "  points");
    };
  const sweep::SweepResult r = sweep::run_sweep(d, options);
  if (!a.quiet) {
    progress.finish();
    print_result(d, r, table);
  }
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

}  // namespace tdbd::app

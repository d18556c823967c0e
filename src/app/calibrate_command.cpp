#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "app/arguments.hpp"
#include "app/case_kind.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "calibration/result/calibration_files.hpp"
#include "core/parallel.hpp"
#include "core/whole_file.hpp"

namespace tdbd::app {
namespace {

struct CalibrateArguments : ResultArguments {
  std::string cuts;
  int threads = 1;
};

/// Where cut runs are kept: beside the result, so that the next calibration finds them.
std::filesystem::path cuts_folder(const CalibrateArguments& a,
                                  const std::filesystem::path& result) {
  if (!a.cuts.empty()) return a.cuts;
  return std::filesystem::absolute(result).lexically_normal().parent_path() / "cuts";
}

void print_set(const calibration::CalibrationCase& c, const calibration::FittedSet& set) {
  const auto names = calibration::load_names(c.records.kind);
  if (set.pressure) say("at {:.2f} MPa:\n", 1e-6 * *set.pressure);
  if (c.unknowns.empty()) return;
  say("{:<16}{:>12}{:>12}   {:.0f} % interval\n", "coefficient", "start", "value",
      100.0 * c.intervals.level);
  for (const calibration::FittedCoefficient& f : set.fit.coefficients)
    say("{:<16}{:>12.5g}{:>12.5g}   {}{}\n", f.key, f.start, f.value,
        f.at_bound ? "at an end of its range" : fmt::format("{:.5g} to {:.5g}", f.low, f.high),
        f.from_prior && !f.at_bound ? ", mostly the prior's" : "");
  say("objectives: {} {:.4g}, {} {:.4g}; chi2 {:.4g} with {} degrees of freedom\n", names[0].name,
      set.fit.objectives[0], names[1].name, set.fit.objectives[1], set.fit.chi2,
      set.fit.degrees_of_freedom);
  say("seen least: {}\n", calibration::in_words(set.fit.problem, set.identifiability));
}

void print_errors(const calibration::CalibrationCase& c, const calibration::Calibration& found) {
  const auto errors = calibration::errors_of(found.predictions);
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (errors[k].readings > 0)
      say("{} of {}: {:.1f} % rms, 95 of 100 within {:.1f} %\n",
          calibration::load_names(c.records.kind)[k].name, fmt::join(c.predict, ", "),
          100.0 * errors[k].rms, 100.0 * errors[k].p95);
  for (const std::string& why : found.extrapolates) say("extrapolates: {}\n", why);
}

calibration::CutStore cuts_for(const calibration::CalibrationCase& c, const CalibrateArguments& a,
                               const std::filesystem::path& folder) {
  Progress progress;
  const auto tell = [&](long done, long total) {
    if (progress.is_due(done, total)) progress.show(done, total, "  cut runs");
  };
  calibration::CutStore cuts = calibration::find_cuts(
      c, cuts_folder(a, folder), a.quiet ? std::function<void(long, long)>() : tell);
  if (!a.quiet && cuts.made > 0) progress.finish();
  return cuts;
}

void write_timing(const std::filesystem::path& folder, const calibration::CutStore& cuts,
                  double cut_seconds, double fit_seconds) {
  write_text(
      folder / "timing.json",
      fmt::format("{{\"cut_runs_made\": {}, \"cut_runs_found\": {}, \"cut_seconds\": {:.4f}, "
                  "\"fit_seconds\": {:.4f}}}\n",
                  cuts.made, cuts.found, cut_seconds, fit_seconds));
}

int calibrate(const CalibrateArguments& a) {
  require_kind(a.case_file, a.overrides, {CaseKind::calibration});
  const auto seconds = [from = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  };
  const ThreadLimit limit(a.threads);
  const std::filesystem::path folder = result_folder(a);
  const auto c = calibration::read_calibration(a.case_file, a.overrides);
  calibration::check_folder(folder, overwrite_of(a.force));
  const calibration::CutStore cuts = cuts_for(c, a, folder);
  const double cut_seconds = seconds();
  const calibration::Calibration found = calibration::calibrate(c, cuts);
  const double fit_seconds = seconds() - cut_seconds;
  const auto held = calibration::prepare_folder(folder, overwrite_of(a.force), c.files);
  write_timing(folder, cuts, cut_seconds, fit_seconds);
  calibration::write_calibration(folder, c, cuts, found);
  if (a.quiet) return 0;
  for (const std::string& warning : found.warnings)
    fmt::print(stderr, "tdbd: warning: {}\n", warning);
  for (const calibration::FittedSet& set : found.sets) print_set(c, set);
  print_errors(c, found);
  say("results in {}\n", folder.string());
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
  command->add_option("--cuts", a->cuts,
                      "folder where cut runs are kept and found again; default: cuts, beside the "
                      "result folder");
  add_threads(*command, a->threads);
  command->footer(
      "The keys of a calibration: tdbd keys calibration.\n"
      "Example: tdbd calibrate validation/cases/lab-bc-a.toml -o out/bc-a");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return calibrate(*a); }); });
}

}  // namespace tdbd::app

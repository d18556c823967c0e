#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/progress.hpp"
#include "calibration/result/calibrate.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::app {
namespace {

struct CalibrateArguments : ResultArguments {
  std::string cuts;
  int threads = 1;
};

void print_set(const calibration::CalibrationCase& c, const calibration::FittedSet& set) {
  const auto names = calibration::load_names(c.records.kind);
  if (set.pressure) say("at {:.2f} MPa:\n", 1e-6 * *set.pressure);
  if (c.unknowns.empty()) return;
  say("{:<16}{:>12}{:>12}   {:.0f} % interval\n", "coefficient", "start", "value",
      100.0 * c.intervals.level);
  for (const calibration::FittedCoefficient& f : set.fit.coefficients)
    say("{:<16}{:>12.5g}{:>12.5g}   {}{}\n", f.key, f.start, f.value,
        f.at_bound ? "at an end of its range" : fmt::format("{:.5g} to {:.5g}", f.low, f.high),
        f.from_prior && !f.at_bound ? ", mostly from the prior" : "");
  say("objectives: {} {:.4g}, {} {:.4g}; chi2 {:.4g} with {} degrees of freedom\n", names[0].name,
      set.fit.objectives[0], names[1].name, set.fit.objectives[1], set.fit.chi2,
      set.fit.degrees_of_freedom);
  say("weakest direction: {}\n", calibration::in_words(set.fit.problem, set.identifiability));
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

}  // namespace tdbd::app

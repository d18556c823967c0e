#include "calibration/result/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "calibration/result/calibration_files.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "io/whole_file.hpp"
#include "simulation/result/summary.hpp"

namespace tdbd::calibration {
namespace {

/// Returns each pressure of the fitted records for separate fits; otherwise one empty value, for
/// all pressures together.
std::vector<std::optional<double>> pressures_of(const CalibrationCase& c) {
  if (c.pressures == Pressures::combined || c.unknowns.empty()) return {std::nullopt};
  std::set<double> pressures;
  for (const Record& r : records_of(c, c.fit)) pressures.insert(r.pressure);
  return {pressures.begin(), pressures.end()};
}

std::vector<Record> at_pressure(const std::vector<Record>& records,
                                const std::optional<double>& pressure) {
  std::vector<Record> chosen;
  for (const Record& r : records)
    if (!pressure || r.pressure == *pressure) chosen.push_back(r);
  return chosen;
}

FittedSet fit_set(const CalibrationCase& c, const CutStore& cuts,
                  const std::optional<double>& pressure) {
  const std::vector<Record> records = at_pressure(records_of(c, c.fit), pressure);
  const Problem problem = problem_of(c, cuts, records);
  require_identifiable(problem);
  FittedSet set{pressure, fit(problem, c.intervals), {}, {}, {}};
  set.identifiability = identifiability_at(set.fit.problem, set.fit.values);
  set.discrepancy = leave_one_tool_out(c, cuts, records);
  set.replicates = bootstrap(set.fit, c.intervals);
  return set;
}

/// Returns the coefficients for a record: those of its pressure or, if that was not fitted, of the
/// nearest fitted pressure.
const FittedSet& set_for(const std::vector<FittedSet>& sets, const Record& record) {
  return *std::ranges::min_element(sets, {}, [&](const FittedSet& s) {
    return s.pressure ? std::abs(*s.pressure - record.pressure) : 0.0;
  });
}

std::vector<Sample> samples_of(const CalibrationCase& c, const CutStore& cuts,
                               const std::vector<Record>& records) {
  std::vector<Sample> samples;
  samples.reserve(records.size());
  for (const Record& r : records) samples.push_back(sample_of(c, cuts, r));
  return samples;
}

std::vector<Prediction> predictions_of(const CalibrationCase& c, const CutStore& cuts,
                                       const std::vector<FittedSet>& sets,
                                       const std::vector<Record>& records) {
  const std::vector<Sample> samples = samples_of(c, cuts, records);
  std::vector<Prediction> all;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const FittedSet& set = set_for(sets, records[i]);
    all.push_back(
        predict(set.fit, samples[i], records[i], c.noise, set.discrepancy, c.intervals.level));
  }
  return all;
}

void warn(const FittedSet& set, std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < set.fit.coefficients.size(); ++k) {
    const FittedCoefficient& f = set.fit.coefficients[k];
    if (f.at_bound)
      warnings.push_back(fmt::format("{}: {:.4g} is an end of its range: no interval",
                                     set.fit.problem.unknowns[k].place, f.value));
  }
  if (!set.discrepancy.reason.empty())
    warnings.push_back("the law's discrepancy is unknown, intervals hold noise alone: " +
                       set.discrepancy.reason);
  if (set.replicates.failed > 0)
    warnings.push_back(fmt::format("{} of {} replicates of the bootstrap did not converge",
                                   set.replicates.failed, set.replicates.replicates));
}

/// For separate fits: warns about each pressure of predicted records that was not fitted.
void warn_of_nearest_sets(const std::vector<FittedSet>& sets, const std::vector<Record>& predicted,
                          std::vector<std::string>& warnings) {
  constexpr double MPa = 1e6;
  std::map<double, double> used;  // pressure of the coefficients, by pressure of the records
  for (const Record& r : predicted) {
    const FittedSet& set = set_for(sets, r);
    if (set.pressure && *set.pressure != r.pressure) used[r.pressure] = *set.pressure;
  }
  for (const auto& [pressure, fitted] : used)
    warnings.push_back(fmt::format(
        "predictions at {:.4g} MPa use the coefficients fitted at {:.4g} MPa, the nearest pressure "
        "fitted: separate fits are not interpolated",
        pressure / MPa, fitted / MPa));
}

/// Returns the folder of cut runs. The default is beside the result folder, so that the next
/// calibration finds them.
std::filesystem::path cuts_folder(const CalibrateOptions& o) {
  if (!o.cuts.empty()) return o.cuts;
  return std::filesystem::absolute(o.folder).lexically_normal().parent_path() / "cuts";
}

void write_timing(const std::filesystem::path& folder, const CutStore& cuts, double cut_seconds,
                  double fit_seconds) {
  write_text(
      folder / "timing.json",
      fmt::format("{{\"cut_runs_made\": {}, \"cut_runs_found\": {}, \"cut_seconds\": {:.4f}, "
                  "\"fit_seconds\": {:.4f}}}\n",
                  cuts.made, cuts.found, cut_seconds, fit_seconds));
}

}  // namespace

Calibration calibrate(const CalibrationCase& c, const CutStore& cuts) {
  Calibration result;
  for (const auto& pressure : pressures_of(c)) result.sets.push_back(fit_set(c, cuts, pressure));
  const std::vector<Record> fitted = records_of(c, c.fit), withheld = records_of(c, c.predict);
  result.fitted = predictions_of(c, cuts, result.sets, fitted);
  result.predictions = predictions_of(c, cuts, result.sets, withheld);
  result.extrapolates = extrapolations(samples_of(c, cuts, fitted), samples_of(c, cuts, withheld));
  for (const FittedSet& set : result.sets) warn(set, result.warnings);
  warn_of_nearest_sets(result.sets, withheld, result.warnings);
  return result;
}

Calibration calibrate_into(const CalibrationCase& c, const CalibrateOptions& o) {
  const auto started = std::chrono::steady_clock::now();
  const ThreadLimit limit(o.threads);
  check_folder(o.folder, o.overwrite);
  const CutStore cuts = find_cuts(c, cuts_folder(o), o.progress);
  const double cut_seconds = simulation::seconds_since(started);
  Calibration found = calibrate(c, cuts);
  const double fit_seconds = simulation::seconds_since(started) - cut_seconds;
  const auto held = prepare_folder(o.folder, o.overwrite, c.files);
  write_timing(o.folder, cuts, cut_seconds, fit_seconds);
  write_calibration(o.folder, c, cuts, found);
  return found;
}

}  // namespace tdbd::calibration

#include "calibration/result/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "calibration/fit/quality.hpp"
#include "calibration/result/answer.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/provenance.hpp"
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
  FittedSet set{pressure, fit_with_loss(c, cuts, problem), {}, {}, {}, {}};
  set.identifiability = identifiability_at(set.fit.problem, set.fit.values);
  set.discrepancy = leave_one_tool_out(c, cuts, records);
  set.replicates = bootstrap(set.fit, c.intervals);
  return set;
}

/// Replaces the standardised residuals of fitted records by those of the fit, which contain the
/// noise only.
void standardise_fitted(const FittedSet& set, std::vector<Prediction>& fitted) {
  std::vector<Prediction*> of_set;
  for (Prediction& p : fitted)
    if (!set.pressure || p.record.pressure == *set.pressure) of_set.push_back(&p);
  for (const FittedReading& r : set.quality.readings)
    of_set[r.record]->loads[r.load].standardised = r.deviations;
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

void warn(const CalibrationCase& c, const FittedSet& set, std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < set.fit.coefficients.size(); ++k) {
    const FittedCoefficient& f = set.fit.coefficients[k];
    if (f.at_bound)
      warnings.push_back(fmt::format("{}: {:.4g} is an end of its range: no interval",
                                     set.fit.problem.unknowns[k].place, f.value));
  }
  if (!set.discrepancy.reason.empty())
    warnings.push_back("the error of the law is unknown, so intervals contain the noise only: " +
                       set.discrepancy.reason);
  if (const std::string misfit = misfit_warning(set, c.records); !misfit.empty())
    warnings.push_back(misfit);
  if (set.replicates.failed > 0)
    warnings.push_back(
        fmt::format("{} of {} replicates of the bootstrap did not converge and are left out",
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
  result.warnings = c.doubts;
  for (const auto& pressure : pressures_of(c)) result.sets.push_back(fit_set(c, cuts, pressure));
  for (FittedSet& set : result.sets) set.quality = quality_of(set.fit, result.sets.size());
  const std::vector<Record> fitted = records_of(c, c.fit), withheld = records_of(c, c.predict);
  result.fitted = predictions_of(c, cuts, result.sets, fitted);
  for (const FittedSet& set : result.sets) standardise_fitted(set, result.fitted);
  result.predictions = predictions_of(c, cuts, result.sets, withheld);
  result.extrapolates = extrapolations(samples_of(c, cuts, fitted), samples_of(c, cuts, withheld));
  for (const FittedSet& set : result.sets) warn(c, set, result.warnings);
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

namespace {

namespace fs = std::filesystem;

/// Whether a file is one that a calibration writes to its folder.
bool is_result(const fs::path& file) {
  static const std::regex names(
      R"((calibration\.json|law(-[0-9.]+MPa)?\.toml|residuals\.csv|predictions\.csv|case\.toml|timing\.json|cuts-[0-9a-f]{16}\.nc)(\.partial)?)");
  return std::regex_match(file.filename().string(), names);
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw FolderError(fmt::format("output folder {}: {}", folder.string(), reason));
}

std::string law_file(const FittedSet& set) {
  if (!set.pressure) return "law.toml";
  constexpr double Pa_to_MPa = 1e-6;
  return fmt::format("law-{:.3f}MPa.toml", Pa_to_MPa * *set.pressure);
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string header(ToolKind kind) {
  const auto names = load_names(kind);
  std::string text = kind == ToolKind::bit ? "test,bit,rock,pressure [Pa],rotary_speed [rad/s],"
                                             "rate_of_penetration [m/s]"
                                           : "test,cutter,rock,pressure [Pa],speed [m/s],depth [m]";
  for (const LoadName& n : names) text += fmt::format(",{} [{}]", n.name, n.si_unit);
  for (const LoadName& n : names)
    for (const char* what : {"mean", "se", "low", "high"})
      text += fmt::format(",{}_{} [{}]", n.name, what, n.si_unit);
  for (const LoadName& n : names) text += fmt::format(",measured_{} [{}]", n.name, n.si_unit);
  for (const LoadName& n : names) text += fmt::format(",{}_standardised [1]", n.name);
  return text + "\n";
}

std::string row(ToolKind kind, const Prediction& p) {
  const Record& r = p.record;
  std::string text = fmt::format("{},{},{},{},{},{}", r.test, r.tool, r.rock, r.pressure, r.speed,
                                 kind == ToolKind::bit ? r.rate : r.depth);
  for (const Reading& reading : r.readings) text += "," + number(reading.value);
  for (const PredictedLoad& load : p.loads)
    text += fmt::format(",{},{},{},{}", load.mean, load.se, load.low, load.high);
  for (const Reading& reading : r.readings) text += "," + number(reading.value);
  for (const PredictedLoad& load : p.loads) text += "," + number(load.standardised);
  return text + "\n";
}

using Json = nlohmann::ordered_json;

std::string unit_of(const forces::Law& law, const std::string& key) {
  forces::Law copy = law;
  for (const forces::LawField& f : forces::law_fields(copy))
    if (f.key == key) return std::string(f.unit);
  return "";
}

Json coefficient_json(const FittedSet& set, std::size_t k) {
  const FittedCoefficient& f = set.fit.coefficients[k];
  Json json{{"unit", unit_of(set.fit.law, law_key(set.fit.problem.unknowns[k]))},
            {"start", f.start},
            {"value", f.value},
            {"se", f.at_bound ? Json() : Json(f.se)},
            {"low", f.at_bound ? Json() : Json(f.low)},
            {"high", f.at_bound ? Json() : Json(f.high)},
            {"from_prior", f.from_prior},
            {"at_bound", f.at_bound}};
  const auto& prior = set.fit.problem.unknowns[k].prior_sd;
  json["prior_sd"] = prior ? Json(*prior) : Json();
  if (set.replicates.coefficients.empty()) return json;
  const BootstrapSummary& b = set.replicates.coefficients[k];
  json["bootstrap"] = {{"mean", b.mean}, {"se", b.se}, {"low", b.low}, {"high", b.high}};
  return json;
}

Json direction_json(const FittedSet& set) {
  Json json = Json::object();
  for (std::size_t k = 0; k < set.fit.coefficients.size(); ++k)
    json[set.fit.coefficients[k].key] = set.identifiability.weakest_direction[k];
  return json;
}

Json set_json(const FittedSet& set, ToolKind kind) {
  const auto names = load_names(kind);
  Json coefficients = Json::object();
  for (std::size_t k = 0; k < set.fit.coefficients.size(); ++k)
    coefficients[set.fit.coefficients[k].key] = coefficient_json(set, k);
  Json json;
  if (set.pressure) json["pressure_pa"] = *set.pressure;
  json["coefficients"] = coefficients;
  for (const std::size_t k : {axial, turning})
    json[fmt::format("objective_{}", names[k].name)] = set.fit.objectives[k];
  json["chi2"] = set.fit.chi2;
  json["degrees_of_freedom"] = set.fit.degrees_of_freedom;
  json["readings"] = set.fit.problem.readings();
  json.update(quality_json(set, kind));
  json["evaluations"] = set.fit.evaluations;
  json["singular_values"] = set.identifiability.singular_values;
  json["weakest_direction"] = direction_json(set);
  json["weakest_direction_in_words"] = in_words(set.fit.problem, set.identifiability);
  for (const std::size_t k : {axial, turning})
    json[fmt::format("discrepancy_{}", names[k].name)] =
        set.discrepancy.reason.empty() ? Json(set.discrepancy.value[k]) : Json();
  json["bootstrap_replicates"] = set.replicates.replicates;
  json["bootstrap_failed"] = set.replicates.failed;
  return json;
}

/// Adds the sums of the objectives of separate fits.
void add_sums(const Calibration& found, const std::array<LoadName, 2>& names, Json& json) {
  for (const std::size_t k : {axial, turning}) {
    double sum = 0.0;
    for (const FittedSet& s : found.sets) sum += s.fit.objectives[k];
    json[fmt::format("objective_{}", names[k].name)] = sum;
  }
  long freedom = 0;
  for (const FittedSet& s : found.sets) freedom += s.fit.degrees_of_freedom;
  json["degrees_of_freedom"] = freedom;
  const auto is_misfit = [](const FittedSet& s) { return !s.quality.fits().value_or(true); };
  json["fits"] = std::ranges::none_of(found.sets, is_misfit);
}

}  // namespace

void check_folder(const fs::path& folder, Overwrite overwrite) {
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error)) refuse(folder, "is a file");
  const bool empty = fs::is_empty(folder, error);
  if (error) refuse(folder, error.message());
  if (!empty && overwrite == Overwrite::no) refuse(folder, "exists; --force overwrites");
}

OutputFolder prepare_folder(const fs::path& folder, Overwrite overwrite,
                            const std::vector<std::string>& inputs) {
  check_folder(folder, overwrite);
  try {
    fs::create_directories(folder);
    OutputFolder held{folder, std::make_shared<const FolderLock>(folder)};
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder))
      if (is_result(entry.path())) old.push_back(entry.path());
    demand_replaceable(folder, old, inputs);
    demand_own(folder, "case.toml");
    for (const fs::path& file : old) fs::remove(file);
    return held;
  } catch (const fs::filesystem_error& e) {
    refuse(folder, e.code().message());
  }
}

std::string law_toml(const forces::Law& law) {
  forces::Law copy = law;
  std::string text = fmt::format("[forces]\nlaw = \"{}\"\n", forces::law_name(law));
  for (const forces::LawField& f : forces::law_fields(copy))
    if (std::isfinite(*f.value))
      text += fmt::format("{} = {}{}\n", f.key, *f.value,
                          f.unit == "1" ? "" : fmt::format("  # {}", f.unit));
  return text;
}

std::string predictions_csv(ToolKind kind, const std::vector<Prediction>& predictions) {
  std::string text = header(kind);
  for (const Prediction& p : predictions) text += row(kind, p);
  return text;
}

void write_calibration(const fs::path& folder, const CalibrationCase& c, const CutStore& cuts,
                       const Calibration& found) {
  write_text(folder / "case.toml", std::string(resolved_head) + "\n" + c.resolved);
  for (const fs::path& file : cuts.files)
    fs::copy_file(file, folder / file.filename(), fs::copy_options::overwrite_existing);
  for (const FittedSet& set : found.sets)
    write_text(
        folder / law_file(set),
        law_toml(set.fit.law) + areas_toml(areas_at(set.fit.problem, set.fit.values), set.fit.law));
  write_text(folder / "residuals.csv", predictions_csv(c.records.kind, found.fitted));
  write_text(folder / "predictions.csv", predictions_csv(c.records.kind, found.predictions));
  write_text(folder / "calibration.json", to_json(c, found));
}

std::string to_json(const CalibrationCase& c, const Calibration& found) {
  const auto names = load_names(c.records.kind);
  Json json{{"schema", 1},
            {"command", "calibrate"},
            {"law", forces::law_name(c.law)},
            {"pressures", c.pressures == Pressures::combined ? "combined" : "separate"},
            {"fit_bits", c.fit},
            {"predict_bits", c.predict}};
  if (!found.sets.front().pressure) {
    json.update(set_json(found.sets.front(), c.records.kind));
  } else {
    add_sums(found, names, json);
    for (const FittedSet& s : found.sets)
      json["by_pressure"].push_back(set_json(s, c.records.kind));
  }
  json.update(errors_json(found.fitted, "fitted_bit_error", c.records.kind));
  json.update(errors_json(found.predictions, "withheld_bit_error", c.records.kind));
  json["extrapolates"] = !found.extrapolates.empty();
  json["extrapolates_because"] = found.extrapolates;
  json["warnings"] = found.warnings;
  json["interval_level"] = c.intervals.level;
  json["seed"] = c.intervals.seed;
  json["records_hash"] = c.records_hash;
  json["case_hash"] = c.hash;
  json["version"] = provenance().version;
  json["commit"] = provenance().commit;
  return json.dump(2) + "\n";
}

}  // namespace tdbd::calibration

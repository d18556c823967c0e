#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "calibration/result/calibration_files.hpp"
#include "core/provenance.hpp"

namespace tdbd::calibration {
namespace {

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
  const BootstrapFigures& b = set.replicates.coefficients[k];
  json["bootstrap"] = {{"mean", b.mean}, {"se", b.se}, {"low", b.low}, {"high", b.high}};
  return json;
}

Json direction_json(const FittedSet& set) {
  Json json = Json::object();
  for (std::size_t k = 0; k < set.fit.coefficients.size(); ++k)
    json[set.fit.coefficients[k].key] = set.identifiability.weakest_direction[k];
  return json;
}

Json set_json(const FittedSet& set, const std::array<LoadName, 2>& names) {
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

void add_errors(const std::vector<Prediction>& predictions, const std::string& what,
                const std::array<LoadName, 2>& names, Json& json) {
  const auto errors = errors_of(predictions);
  for (const std::size_t k : {axial, turning}) {
    const bool read = errors[k].readings > 0;
    json[fmt::format("{}_{}_rms", what, names[k].name)] = read ? Json(errors[k].rms) : Json();
    json[fmt::format("{}_{}_p95", what, names[k].name)] = read ? Json(errors[k].p95) : Json();
  }
}

/// Objectives of separate fits add up.
void add_sums(const Calibration& found, const std::array<LoadName, 2>& names, Json& json) {
  for (const std::size_t k : {axial, turning}) {
    double sum = 0.0;
    for (const FittedSet& s : found.sets) sum += s.fit.objectives[k];
    json[fmt::format("objective_{}", names[k].name)] = sum;
  }
  long freedom = 0;
  for (const FittedSet& s : found.sets) freedom += s.fit.degrees_of_freedom;
  json["degrees_of_freedom"] = freedom;
}

}  // namespace

std::string to_json(const CalibrationCase& c, const Calibration& found) {
  const auto names = load_names(c.records.kind);
  Json json{{"schema", 1},
            {"command", "calibrate"},
            {"law", forces::law_name(c.law)},
            {"pressures", c.pressures == Pressures::combined ? "combined" : "separate"},
            {"fit_bits", c.fit},
            {"predict_bits", c.predict}};
  if (!found.sets.front().pressure) {
    json.update(set_json(found.sets.front(), names));
  } else {
    add_sums(found, names, json);
    for (const FittedSet& s : found.sets) json["by_pressure"].push_back(set_json(s, names));
  }
  add_errors(found.fitted, "fitted_bit_error", names, json);
  add_errors(found.predictions, "withheld_bit_error", names, json);
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

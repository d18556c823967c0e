#include "calibration/result/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace tdbd::calibration {
namespace {

using Json = nlohmann::ordered_json;

constexpr double two_deviations = 2.0;
constexpr std::size_t most_rows = 5;
constexpr double per_MPa = 1e6;

std::string coefficients_text(const CalibrationCase& c, const FittedSet& set) {
  std::string text = fmt::format("{:<16}{:>12}{:>12}   {:.0f} % interval\n", "coefficient", "start",
                                 "value", 100.0 * c.intervals.level);
  for (const FittedCoefficient& f : set.fit.coefficients)
    text += fmt::format(
        "{:<16}{:>12.5g}{:>12.5g}   {}{}\n", f.key, f.start, f.value,
        f.at_bound ? "at an end of its range" : fmt::format("{:.5g} to {:.5g}", f.low, f.high),
        f.from_prior && !f.at_bound ? ", mostly from the prior" : "");
  return text;
}

/// "chi2 51 with 7 degrees of freedom (7.3 each), p = 9e-09".
std::string test_text(const FitQuality& q) {
  const auto freedom = static_cast<double>(q.degrees_of_freedom);
  return fmt::format("chi2 {:.4g} with {} degrees of freedom ({:.2g} each), p = {:.2g}",
                     q.statistic, q.degrees_of_freedom, q.statistic / freedom, q.p_value);
}

double measured(const FittedSet& set, const FittedReading& r) {
  return *set.fit.problem.records[r.record].readings[r.load].value;
}

std::string row_text(const FittedSet& set, ToolKind kind, const FittedReading& r) {
  const Record& record = set.fit.problem.records[r.record];
  const LoadName load = load_names(kind)[r.load];
  const double value = measured(set, r);
  return fmt::format("{:>6}  {:<12}{:<10}{:<7}{:>12.5g}{:>12.5g} {:<4}{:>+8.1f}{:>+10.1f}\n",
                     record.line, record.test, record.tool, load.name, value, r.ratio * value,
                     load.si_unit, r.deviations, r.deviations_in_test);
}

std::string worst_text(const FittedSet& set, ToolKind kind) {
  const auto worst = worst_readings(set.quality, two_deviations, most_rows);
  if (worst.empty())
    return "  No single reading is more than 2 standard deviations away; all of them share the "
           "misfit.\n";
  std::string text = fmt::format(
      "  The readings that fit worst, in standard deviations (computed above measured: +):\n"
      "{:>6}  {:<12}{:<10}{:<7}{:>12}{:>12} {:<4}{:>8}{:>10}\n",
      "line", "test", "tool", "load", "measured", "computed", "", "alone", "in test");
  for (const FittedReading& r : worst) text += row_text(set, kind, r);
  return text;
}

std::string quality_text(const FittedSet& set, ToolKind kind) {
  const FitQuality& q = set.quality;
  const std::string counts = fmt::format("{} of {} readings are within 2 standard deviations.\n",
                                         readings_within(q, two_deviations), q.readings.size());
  if (!q.fits())
    return "fit: not tested. With no degrees of freedom, any law fits the readings.\n" + counts;
  if (*q.fits())
    return fmt::format("fit: {}. The law fits the readings.\n{}", test_text(q), counts);
  return fmt::format(
      "fit: {}. THE LAW DOES NOT FIT THE READINGS.\n"
      "  A law that fits gives this result in fewer than {:.0f} of 100 calibrations.\n"
      "  The intervals are therefore too narrow. Possible causes: a wrong reading, more noise than "
      "in [noise], or another law.\n{}{}",
      test_text(q), 100.0 * false_alarm, worst_text(set, kind), counts);
}

std::string set_text(const CalibrationCase& c, const FittedSet& set) {
  const auto names = load_names(c.records.kind);
  if (set.quality.readings.empty()) return "";
  std::string text;
  if (set.pressure) text += fmt::format("at {:.2f} MPa:\n", *set.pressure / per_MPa);
  if (!c.unknowns.empty()) text += coefficients_text(c, set);
  text += fmt::format("objectives, readings taken as independent: {} {:.4g}, {} {:.4g}\n",
                      names[0].name, set.fit.objectives[0], names[1].name, set.fit.objectives[1]);
  text += quality_text(set, c.records.kind);
  if (!c.unknowns.empty())
    text += "weakest direction: " + in_words(set.fit.problem, set.identifiability) + "\n";
  return text;
}

/// "wob of A: 4.2 % rms, at most 7.1 %; 5 of 5 readings within 2 standard deviations".
std::string errors_text(const CalibrationCase& c, const Calibration& found) {
  const auto errors = errors_of(found.predictions);
  std::string text;
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (errors[k].readings > 0)
      text += fmt::format(
          "{} of {}: {:.1f} % rms, at most {:.1f} %; {} of {} readings within 2 standard "
          "deviations\n",
          load_names(c.records.kind)[k].name, fmt::join(c.predict, ", "), 100.0 * errors[k].rms,
          100.0 * errors[k].largest, errors[k].within_two, errors[k].readings);
  for (const std::string& why : found.extrapolates) text += "extrapolates: " + why + "\n";
  return text;
}

/// The predicted loads that were not measured, at most eight:
/// "test later of other: wob 37392 N, 33769 to 41402 N".
std::string unmeasured_text(const CalibrationCase& c, const Calibration& found) {
  constexpr long most = 8;
  const auto names = load_names(c.records.kind);
  std::string text;
  long lines = 0;
  for (const Prediction& p : found.predictions)
    for (std::size_t k = 0; k < p.loads.size(); ++k)
      if (const PredictedLoad& load = p.loads[k]; !load.standardised && lines++ < most)
        text += fmt::format("test {} of {}: {} {:.5g} {}, {:.5g} to {:.5g} {}\n", p.record.test,
                            p.record.tool, names[k].name, load.mean, names[k].si_unit, load.low,
                            load.high, names[k].si_unit);
  if (lines > most)
    text += fmt::format("and {} more predicted loads in predictions.csv\n", lines - most);
  return text;
}

}  // namespace

std::vector<std::string> assumptions_of(const FittedSet& set) {
  std::vector<std::string> all{
      "Intervals of coefficients assume that the law is right.",
      "They assume normal noise of the size given in [noise] and in the records.",
      "They assume that the law is linear within the noise; intervals.bootstrap checks this."};
  if (set.replicates.replicates > 0)
    all.emplace_back("The bootstrap draws readings from the fitted law and assumes the same.");
  all.emplace_back(set.discrepancy.reason.empty()
                       ? "Intervals of predictions add the error of the law, observed on fitted "
                         "bits left out in turn."
                       : "Intervals of predictions contain no error of the law, because it is "
                         "unknown.");
  return all;
}

std::string misfit_warning(const FittedSet& set, const Records& records) {
  if (set.quality.fits().value_or(true)) return "";
  const auto worst = worst_readings(set.quality, two_deviations, 1);
  std::string row;
  if (!worst.empty())
    row = fmt::format(
        "; the {} of {}:{} fits worst, {:.3g} standard deviations away",
        load_names(records.kind)[worst.front().load].name, records.file,
        set.fit.problem.records[worst.front().record].line,
        std::max(std::abs(worst.front().deviations), std::abs(worst.front().deviations_in_test)));
  return fmt::format("the law does not fit the readings{}: {}{}",
                     set.pressure ? fmt::format(" at {:.4g} MPa", *set.pressure / per_MPa) : "",
                     test_text(set.quality), row);
}

std::string answer_text(const CalibrationCase& c, const Calibration& found) {
  std::string text;
  for (const FittedSet& set : found.sets) text += set_text(c, set);
  text += errors_text(c, found) + unmeasured_text(c, found);
  if (c.unknowns.empty()) return text;
  return text +
         fmt::format("assumptions: {}\n", fmt::join(assumptions_of(found.sets.front()), "\n  "));
}

Json quality_json(const FittedSet& set, ToolKind kind) {
  const FitQuality& q = set.quality;
  const bool tested = q.fits().has_value();
  Json json{{"fits", tested ? Json(*q.fits()) : Json()}};
  json["fit_test"] = {
      {"statistic", q.statistic},
      {"degrees_of_freedom", q.degrees_of_freedom},
      {"reduced_chi2",
       tested ? Json(q.statistic / static_cast<double>(q.degrees_of_freedom)) : Json()},
      {"p_value", tested ? Json(q.p_value) : Json()},
      {"rejected_below", q.threshold},
      {"false_alarm_probability", false_alarm}};
  json["readings_within_2_deviations"] = readings_within(q, two_deviations);
  json["worst_readings"] = Json::array();
  for (const FittedReading& r : worst_readings(q, two_deviations, most_rows)) {
    const Record& record = set.fit.problem.records[r.record];
    json["worst_readings"].push_back({{"line", record.line},
                                      {"test", record.test},
                                      {"tool", record.tool},
                                      {"load", load_names(kind)[r.load].name},
                                      {"measured", measured(set, r)},
                                      {"computed", r.ratio * measured(set, r)},
                                      {"deviations", r.deviations},
                                      {"deviations_in_test", r.deviations_in_test}});
  }
  json["intervals_assume"] = assumptions_of(set);
  return json;
}

Json errors_json(const std::vector<Prediction>& predictions, const std::string& what,
                 ToolKind kind) {
  const auto errors = errors_of(predictions);
  Json json = Json::object();
  for (const std::size_t k : {axial, turning}) {
    const PredictionError& e = errors[k];
    const std::string name = fmt::format("{}_{}", what, load_names(kind)[k].name);
    const bool read = e.readings > 0;
    json[name + "_rms"] = read ? Json(e.rms) : Json();
    json[name + "_largest"] = read ? Json(e.largest) : Json();
    json[name + "_p95"] = e.readings >= least_for_p95 ? Json(e.p95) : Json();
    json[name + "_readings"] = e.readings;
    json[name + "_within_2_deviations"] = e.within_two;
  }
  return json;
}

}  // namespace tdbd::calibration

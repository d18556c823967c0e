#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "calibration/fit/trust_region.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "calibration/result/calibrate.hpp"
#include "core/provenance.hpp"

namespace tdbd::calibration::calibration_files_test {
namespace {

using nlohmann::json;

/// Noisy readings with three replicates of the bootstrap, and a prior.
CalibrationCase noisy_case() {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03, .test = 0.03, .rop = 0.02};
  c.intervals = {.level = 0.9, .bootstrap = 3, .seed = 7};
  c.hash = "case";
  c.records_hash = "records";
  unknown(c, "A6")->prior_sd = 0.2;
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.03}, 5);
  return c;
}

/// At two pressures, without the coefficient that needs both.
CalibrationCase separate_case() {
  CalibrationCase c = noisy_case();
  c.pressures = Pressures::separate;
  std::erase_if(c.unknowns, [](const Unknown& u) { return u.key == "pressure_share"; });
  return c;
}

Calibration found_for(const CalibrationCase& c) { return calibrate(c, made_up_cuts(c)); }

void expect_coefficients(const json& found, const FittedSet& set) {
  ASSERT_EQ(found.size(), set.fit.coefficients.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const FittedCoefficient& f = set.fit.coefficients[k];
    const json& one = found.at(f.key);
    EXPECT_EQ(one.at("unit"), f.key == "A3" ? "rad" : "1");
    EXPECT_EQ(one.at("start"), f.start);
    EXPECT_EQ(one.at("value"), f.value);
    EXPECT_EQ(one.at("from_prior"), f.from_prior);
    EXPECT_EQ(one.at("at_bound"), f.at_bound);
    for (const auto& [key, number] : {std::pair{"se", f.se}, {"low", f.low}, {"high", f.high}})
      EXPECT_EQ(one.at(key), f.at_bound ? json() : json(number)) << f.key << ' ' << key;
    EXPECT_EQ(one.at("prior_sd"), f.key == "A6" ? json(0.2) : json());
    const BootstrapSummary& b = set.replicates.coefficients.at(k);
    EXPECT_EQ(one.at("bootstrap"),
              (json{{"mean", b.mean}, {"se", b.se}, {"low", b.low}, {"high", b.high}}));
  }
}

void expect_set(const json& found, const FittedSet& set) {
  expect_coefficients(found.at("coefficients"), set);
  const Fit& fit = set.fit;
  EXPECT_EQ(found.at("objective_wob"), fit.objectives[axial]);
  EXPECT_EQ(found.at("objective_tob"), fit.objectives[turning]);
  EXPECT_EQ(found.at("chi2"), fit.chi2);
  EXPECT_EQ(found.at("degrees_of_freedom"), fit.degrees_of_freedom);
  EXPECT_EQ(found.at("readings"), fit.problem.readings());
  EXPECT_EQ(found.at("evaluations"), fit.evaluations);
  EXPECT_EQ(found.at("singular_values"), set.identifiability.singular_values);
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k)
    EXPECT_EQ(found.at("weakest_direction").at(fit.coefficients[k].key),
              set.identifiability.weakest_direction[k]);
  EXPECT_EQ(found.at("weakest_direction").size(), fit.coefficients.size());
  EXPECT_EQ(found.at("weakest_direction_in_words"), in_words(fit.problem, set.identifiability));
  EXPECT_EQ(found.at("discrepancy_wob"), set.discrepancy.value[axial]);
  EXPECT_EQ(found.at("discrepancy_tob"), set.discrepancy.value[turning]);
  EXPECT_EQ(found.at("bootstrap_replicates"), 3);
  EXPECT_EQ(found.at("bootstrap_failed"), set.replicates.failed);
}

TEST(CalibrationJson, has_every_number_of_a_fit) {
  const CalibrationCase c = noisy_case();
  const Calibration found = found_for(c);
  const json j = json::parse(to_json(c, found));
  expect_set(j, found.sets.front());
  EXPECT_FALSE(j.contains("pressure_pa"));
  EXPECT_EQ(j.at("schema"), 1);
  EXPECT_EQ(j.at("command"), "calibrate");
  EXPECT_EQ(j.at("law"), "hanson-hansen");
  EXPECT_EQ(j.at("pressures"), "combined");
  EXPECT_EQ(j.at("fit_bits"), c.fit);
  EXPECT_EQ(j.at("predict_bits"), c.predict);
  const auto fitted = errors_of(found.fitted), withheld = errors_of(found.predictions);
  EXPECT_EQ(j.at("fitted_bit_error_wob_rms"), fitted[axial].rms);
  EXPECT_EQ(j.at("fitted_bit_error_tob_largest"), fitted[turning].largest);
  EXPECT_EQ(j.at("fitted_bit_error_tob_readings"), 16);
  EXPECT_TRUE(j.at("fitted_bit_error_tob_p95").is_null());  // of fewer than 20 readings
  EXPECT_EQ(j.at("withheld_bit_error_wob_largest"), withheld[axial].largest);
  EXPECT_EQ(j.at("withheld_bit_error_wob_within_2_deviations"), withheld[axial].within_two);
  EXPECT_EQ(j.at("withheld_bit_error_tob_rms"), withheld[turning].rms);
  EXPECT_EQ(j.at("extrapolates"), !found.extrapolates.empty());
  EXPECT_EQ(j.at("extrapolates_because"), found.extrapolates);
  EXPECT_EQ(j.at("warnings"), found.warnings);
  EXPECT_EQ(j.at("interval_level"), 0.9);
  EXPECT_EQ(j.at("seed"), 7);
  EXPECT_EQ(j.at("records_hash"), "records");
  EXPECT_EQ(j.at("case_hash"), "case");
  EXPECT_EQ(j.at("version"), provenance().version);
  EXPECT_EQ(j.at("commit"), provenance().commit);
}

/// Each pressure has its own set, and their objectives and freedoms add up.
TEST(CalibrationJson, of_separate_fits_has_each_and_their_sums) {
  const CalibrationCase c = separate_case();
  const Calibration found = found_for(c);
  ASSERT_EQ(found.sets.size(), 2U);
  const json j = json::parse(to_json(c, found));
  EXPECT_EQ(j.at("pressures"), "separate");
  ASSERT_EQ(j.at("by_pressure").size(), 2U);
  Loads sums{};
  long freedom = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    expect_set(j.at("by_pressure")[k], found.sets[k]);
    EXPECT_EQ(j.at("by_pressure")[k].at("pressure_pa"), *found.sets[k].pressure);
    for (const std::size_t load : {axial, turning})
      sums[load] += found.sets[k].fit.objectives[load];
    freedom += found.sets[k].fit.degrees_of_freedom;
  }
  EXPECT_EQ(j.at("objective_wob"), sums[axial]);
  EXPECT_EQ(j.at("objective_tob"), sums[turning]);
  EXPECT_EQ(j.at("degrees_of_freedom"), freedom);
  EXPECT_FALSE(j.contains("coefficients"));
}

/// A coefficient at its bound has no interval, what was not read no error, and no bootstrap is none.
TEST(CalibrationJson, has_nulls_for_what_there_is_not) {
  CalibrationCase c = noisy_case();
  c.intervals.bootstrap = 0;
  c.predict.clear();
  Unknown& A5 = *unknown(c, "A5");
  A5.range = Range::within(2.0, 5.0);
  A5.start = 3.0;
  c.fit = {"B"};
  const Calibration found = found_for(c);
  ASSERT_FALSE(found.sets.front().discrepancy.reason.empty());
  const json j = json::parse(to_json(c, found));
  for (const char* key : {"se", "low", "high"})
    EXPECT_TRUE(j.at("coefficients").at("A5").at(key).is_null());
  EXPECT_FALSE(j.at("coefficients").at("A5").contains("bootstrap"));
  for (const char* key :
       {"withheld_bit_error_wob_rms", "withheld_bit_error_wob_p95", "withheld_bit_error_tob_rms",
        "withheld_bit_error_tob_p95", "discrepancy_wob", "discrepancy_tob"})
    EXPECT_TRUE(j.at(key).is_null()) << key;
  EXPECT_FALSE(j.at("extrapolates"));
  ASSERT_EQ(found.warnings.size(), 2U);
  EXPECT_EQ(found.warnings[0], "case.toml:5: unknowns.A5: 2 is an end of its range: no interval");
  EXPECT_EQ(found.warnings[1],
            "the error of the law is unknown, so intervals contain the noise only: " +
                found.sets.front().discrepancy.reason);
}

/// The set of a record is that of its pressure; between two, that of the nearer.
TEST(Calibration, of_separate_fits_predicts_by_the_nearest_pressure) {
  CalibrationCase c = separate_case();
  const double low = c.records.rows.front().pressure, high = c.records.rows.back().pressure;
  for (Record& r : c.records.rows)
    if (r.tool == "A") r.pressure = r.pressure == low ? 0.6 * low + 0.4 * high : 2.0 * high;
  const Calibration found = found_for(c);
  ASSERT_EQ(found.sets.size(), 2U);
  EXPECT_EQ(*found.sets[0].pressure, low);
  EXPECT_EQ(*found.sets[1].pressure, high);
  const auto expect_the_set = [&](const Prediction& p) {
    const FittedSet& set = found.sets[p.record.pressure < 0.5 * (low + high) ? 0 : 1];
    const Sample s = sample_of(cut_run_of(made_up_cuts(c), p.record), p.record,
                               strength_of(c.rock, p.record), c.law);
    const Prediction twin = predict(set.fit, s, p.record, c.noise, set.discrepancy, 0.9);
    for (const std::size_t load : {axial, turning}) {
      EXPECT_EQ(p.loads[load].mean, twin.loads[load].mean);
      EXPECT_EQ(p.loads[load].low, twin.loads[load].low);
      EXPECT_EQ(p.loads[load].high, twin.loads[load].high);
    }
  };
  for (const Prediction& p : found.predictions) expect_the_set(p);
  for (const Prediction& p : found.fitted) expect_the_set(p);
  EXPECT_EQ(found.predictions.size(), 8U);
  EXPECT_EQ(found.fitted.size(), 16U);
  for (const FittedSet& set : found.sets)  // each has seen the records of its own pressure
    for (const Record& r : set.fit.problem.records) EXPECT_EQ(r.pressure, *set.pressure);
  EXPECT_FALSE(found.extrapolates.empty());
}

/// Once for each pressure without a set; not for one fit at all pressures, nor where each pressure was fitted.
TEST(Calibration, of_separate_fits_warns_of_predictions_at_other_pressures) {
  const auto warnings_of = [](const CalibrationCase& c) {
    std::vector<std::string> warnings = found_for(c).warnings;
    std::erase_if(warnings, [](const std::string& w) { return !w.starts_with("predictions"); });
    return warnings;
  };
  CalibrationCase c = separate_case();
  EXPECT_TRUE(warnings_of(c).empty());
  const double low = c.records.rows.front().pressure, high = c.records.rows.back().pressure;
  for (Record& r : c.records.rows)
    if (r.tool == "A") r.pressure = r.pressure == low ? 0.6 * low + 0.4 * high : 2.0 * high;
  EXPECT_EQ(warnings_of(c),
            (std::vector<std::string>{
                "predictions at 28.96 MPa use the coefficients fitted at 20.68 MPa, the nearest "
                "pressure fitted: separate fits are not interpolated",
                "predictions at 82.74 MPa use the coefficients fitted at 41.37 MPa, the nearest "
                "pressure fitted: separate fits are not interpolated"}));
  c.pressures = Pressures::combined;
  EXPECT_TRUE(warnings_of(c).empty());
}

/// Without unknowns there is one set, whatever the pressures.
TEST(Calibration, of_nothing_has_one_set) {
  CalibrationCase c = separate_case();
  c.unknowns.clear();
  c.law = hidden_law();
  const Calibration found = found_for(c);
  ASSERT_EQ(found.sets.size(), 1U);
  EXPECT_FALSE(found.sets.front().pressure);
  EXPECT_EQ(found.sets.front().fit.problem.readings(), 32U);
}

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// A prediction of which no two numbers are the same, and one load was not read.
Prediction numbered() {
  Prediction p;
  p.record = {"t1", "A", "shale", 1.5, 2.5, 3.5, 4.5, {}, 0};
  p.record.readings[axial].value = 5.5;
  p.loads = {PredictedLoad{6.5, 7.5, 8.5, 9.5, -0.5}, PredictedLoad{10.5, 11.5, 12.5, 13.5}};
  return p;
}

TEST(PredictionsCsv, has_each_number_below_its_name) {
  const auto bit = cells_of(predictions_csv(ToolKind::bit, {numbered(), numbered()}));
  ASSERT_EQ(bit.size(), 3U);
  EXPECT_EQ(bit[0], (std::vector<std::string>{"test",
                                              "bit",
                                              "rock",
                                              "pressure [Pa]",
                                              "rotary_speed [rad/s]",
                                              "rate_of_penetration [m/s]",
                                              "wob [N]",
                                              "tob [N m]",
                                              "wob_mean [N]",
                                              "wob_se [N]",
                                              "wob_low [N]",
                                              "wob_high [N]",
                                              "tob_mean [N m]",
                                              "tob_se [N m]",
                                              "tob_low [N m]",
                                              "tob_high [N m]",
                                              "measured_wob [N]",
                                              "measured_tob [N m]",
                                              "wob_standardised [1]",
                                              "tob_standardised [1]"}));
  EXPECT_EQ(bit[1], (std::vector<std::string>{
                        "t1",  "A",   "shale", "1.5",  "2.5",  "3.5",  "5.5", "", "6.5",  "7.5",
                        "8.5", "9.5", "10.5",  "11.5", "12.5", "13.5", "5.5", "", "-0.5", ""}));
  EXPECT_EQ(bit[2], bit[1]);
  const auto cutter = cells_of(predictions_csv(ToolKind::cutter, {numbered()}));
  EXPECT_EQ(std::vector<std::string>(cutter[0].begin(), cutter[0].begin() + 8),
            (std::vector<std::string>{"test", "cutter", "rock", "pressure [Pa]", "speed [m/s]",
                                      "depth [m]", "normal [N]", "drag [N]"}));
  EXPECT_EQ(cutter[1][5], "4.5");
}

/// A key for each coefficient that has a value; units behind them.
TEST(LawToml, has_every_coefficient_that_has_a_value) {
  forces::HansonHansen law = hidden_law();
  law.A7 = std::nan("");
  const std::string text = law_toml(law);
  EXPECT_EQ(text.find("[forces]\nlaw = \"hanson-hansen\"\n"), 0U);
  EXPECT_NE(text.find("\nA1 = 1.3\n"), text.npos) << text;
  EXPECT_NE(text.find(fmt::format("\nA3 = {}  # rad\n", law.A3)), text.npos) << text;
  EXPECT_NE(text.find("\nte = 0.0001  # m\n"), text.npos) << text;
  EXPECT_EQ(text.find("A7"), text.npos) << text;
}

}  // namespace
}  // namespace tdbd::calibration::calibration_files_test

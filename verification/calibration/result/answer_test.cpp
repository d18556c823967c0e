#include "calibration/result/answer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "calibration/made_up_laboratory.hpp"

namespace tdbd::calibration::answer_test {
namespace {

using nlohmann::ordered_json;

CalibrationCase noisy_case() {
  CalibrationCase c = well_conditioned_case();
  c.noise = {.reading = 0.03, .test = 0.0, .rop = 0.0};
  read_loads(c, made_up_cuts(c), hidden_law(), {0.03, 0.0}, 5);
  return c;
}

/// The torque of one record of a fitted bit is 40 % too high.
CalibrationCase misread_case() {
  CalibrationCase c = noisy_case();
  for (std::size_t i = 0; i < c.records.rows.size(); ++i)
    c.records.rows[i].line = static_cast<long>(i) + 2;
  *c.records.rows[10].readings[turning].value *= 1.4;
  return c;
}

std::string answer(const CalibrationCase& c) {
  return answer_text(c, calibrate(c, made_up_cuts(c)));
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CalibrationAnswer, of_a_law_that_fits_says_so) {
  const std::string text = answer(noisy_case());
  EXPECT_TRUE(has(text, " degrees of freedom (")) << text;
  EXPECT_TRUE(has(text, "The law fits the readings.\n")) << text;
  EXPECT_FALSE(has(text, "DOES NOT FIT")) << text;
  EXPECT_TRUE(has(text, " of 32 readings are within 2 standard deviations.\n")) << text;
  EXPECT_TRUE(has(text, " of 8 readings within 2 standard deviations\n")) << text;
  EXPECT_FALSE(has(text, "of 100 within")) << text;
  EXPECT_TRUE(has(text, "assumptions: Intervals of coefficients assume that the law is right."))
      << text;
}

TEST(CalibrationAnswer, of_a_misfit_names_the_reading) {
  const CalibrationCase c = misread_case();
  const std::string text = answer(c);
  EXPECT_TRUE(has(text, "THE LAW DOES NOT FIT THE READINGS.\n")) << text;
  EXPECT_TRUE(has(text, "A law that fits gives this result in fewer than 1 of 100 calibrations."))
      << text;
  const std::size_t head = text.find("  line  test");
  ASSERT_NE(head, text.npos) << text;
  const std::string first = text.substr(text.find('\n', head) + 1);
  EXPECT_EQ(first.rfind("    12  " + c.records.rows[10].test + "      B         tob  ", 0), 0U)
      << text;
}

TEST(CalibrationAnswer, warns_of_a_misfit) {
  const CalibrationCase c = misread_case();
  const Calibration found = calibrate(c, made_up_cuts(c));
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_EQ(found.warnings.back().rfind("the law does not fit the readings: chi2 ", 0), 0U)
      << found.warnings.back();
  for (const std::string& w : calibrate(noisy_case(), made_up_cuts(c)).warnings)
    EXPECT_FALSE(has(w, "does not fit")) << w;
}

/// Words between two full stops or colons; a sentence has at most 25 of them.
TEST(CalibrationAnswer, has_short_sentences) {
  for (const CalibrationCase& c : {noisy_case(), misread_case()}) {
    std::istringstream text(answer(c));
    int words = 0;
    for (std::string word; text >> word;) {
      EXPECT_LE(++words, 25) << "... " << word;
      if (word.ends_with('.') || word.ends_with(':') || word.ends_with(';')) words = 0;
      if (word == "deviations" || word == "each),") words = 0;  // ends of lines and of figures
      if (std::isdigit(word.back()) != 0) words = 0;            // cells of tables
    }
  }
}

TEST(CalibrationAnswer, of_no_freedom_is_not_tested) {
  const CalibrationCase c = noisy_case();
  Calibration found = calibrate(c, made_up_cuts(c));
  found.sets.front().quality.degrees_of_freedom = 0;
  EXPECT_TRUE(has(answer_text(c, found), "fit: not tested. With no degrees of freedom"));
  const ordered_json j = quality_json(found.sets.front(), ToolKind::bit);
  EXPECT_TRUE(j.at("fits").is_null());
  EXPECT_TRUE(j.at("fit_test").at("p_value").is_null());
}

TEST(CalibrationJson, has_the_test_of_the_fit_and_the_worst_readings) {
  const CalibrationCase c = misread_case();
  const Calibration found = calibrate(c, made_up_cuts(c));
  const FittedSet& set = found.sets.front();
  const ordered_json j = ordered_json::parse(to_json(c, found));
  EXPECT_EQ(j.at("fits"), false);
  EXPECT_EQ(j.at("fit_test").at("p_value"), set.quality.p_value);
  EXPECT_EQ(j.at("fit_test").at("statistic"), set.quality.statistic);
  EXPECT_EQ(j.at("fit_test").at("false_alarm_probability"), 0.01);
  EXPECT_EQ(j.at("readings_within_2_deviations"), readings_within(set.quality, 2.0));
  const ordered_json& worst = j.at("worst_readings").at(0);
  EXPECT_EQ(worst.at("line"), 12);
  EXPECT_EQ(worst.at("tool"), "B");
  EXPECT_EQ(worst.at("load"), "tob");
  EXPECT_EQ(worst.at("measured"), *c.records.rows[10].readings[turning].value);
  EXPECT_LT(worst.at("deviations"), -5.0);
  EXPECT_EQ(j.at("intervals_assume").size(), assumptions_of(set).size());
  EXPECT_EQ(ordered_json::parse(to_json(noisy_case(), calibrate(noisy_case(), made_up_cuts(c))))
                .at("fits"),
            true);
}

TEST(CalibrationAnswer, has_the_predicted_loads_that_were_not_measured) {
  const CalibrationCase c = noisy_case();
  Calibration found = calibrate(c, made_up_cuts(c));
  EXPECT_FALSE(has(answer_text(c, found), "\ntest "));
  ASSERT_FALSE(found.predictions.empty());
  Prediction& p = found.predictions.front();
  p.record.test = "later";
  p.record.tool = "C";
  p.loads[axial] = {37391.8, 1.0, 33769.6, 41402.6};
  EXPECT_TRUE(has(answer_text(c, found), "\ntest later of C: wob 37392 N, 33770 to 41403 N\n"))
      << answer_text(c, found);
}

/// The residuals of fitted records are those of the fit.
TEST(CalibrationResiduals, are_standardised_by_the_noise) {
  const CalibrationCase c = noisy_case();
  const Calibration found = calibrate(c, made_up_cuts(c));
  const Fit& f = found.sets.front().fit;
  for (const FittedReading& r : found.sets.front().quality.readings)
    EXPECT_EQ(*found.fitted[r.record].loads[r.load].standardised, r.deviations);
  EXPECT_EQ(found.fitted.size(), f.problem.records.size());
  for (const Prediction& p : found.predictions)
    for (const std::size_t load : {axial, turning})
      EXPECT_LT(std::abs(*p.loads[load].standardised),
                std::abs(std::log(p.loads[load].mean / *p.record.readings[load].value)) / 0.03);
}

}  // namespace
}  // namespace tdbd::calibration::answer_test

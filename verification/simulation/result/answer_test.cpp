#include <gtest/gtest.h>

#include <numbers>

#include "simulation/result/summary.hpp"

namespace tdbd::simulation::answer_test {

using Lines = std::vector<std::string>;

SteadyState means_over(double revolutions, std::optional<bool> is_steady) {
  SteadyState state;
  state.is_steady = is_steady;
  state.revolutions = revolutions;
  return state;
}

/// A bit of 200 mm that drills 36 m/h at 60 rpm.
RunSummary drilled() {
  RunSummary s;
  s.loads.emplace();
  LoadStatisticsSummary& f = *s.loads;
  f.steps = 1000;
  f.wob.mean = 30e3;
  f.tob.mean = 2587.1;
  f.rop.mean = 0.01;
  f.rotary_speed.mean = 2.0 * std::numbers::pi;
  f.uncertainty = {11.0, 1.0, 3e-5, 1e-3, 5e-4};
  f.specific_energy = 139.44e6;
  f.imbalance = 0.049;
  f.imbalance_azimuth = -77.0 * std::numbers::pi / 180.0;
  s.set_weight = 29.9e3;
  s.steady = means_over(3.0, true);
  s.drive.emplace();
  s.diagnosis.text = "steady";
  return s;
}

TEST(Answer, is_six_lines) {
  EXPECT_EQ(answer_lines(drilled(), AnswerUnits::metric),
            (Lines{"weight on bit    30.000 +- 0.011 kN; set: 29.9 kN, difference +0.33 %",
                   "torque on bit    2.5871 +- 0.001 kN m",
                   "rate             36.00 +- 0.11 m/h at 60 rpm, 10 mm per revolution",
                   "specific energy  139.4 MPa",
                   "imbalance        4.900 +- 0.05 % of the weight on bit, azimuth -77 deg",
                   "diagnosis        steady; means over 3 revolutions"}));
}

/// 1 lbf = 4.448222 N, 1 ft lbf = 1.355818 N m, 1 psi = 6894.757 Pa, 1 ft = 0.3048 m.
TEST(Answer, is_given_in_field_units_on_request) {
  RunSummary s = drilled();
  s.loads->uncertainty = {};
  EXPECT_EQ(answer_lines(s, AnswerUnits::field),
            (Lines{"weight on bit    6744 lbf; set: 6722 lbf, difference +0.33 %",
                   "torque on bit    1908 ft lbf",
                   "rate             118.1 ft/h at 60 rpm, 0.3937 in per revolution",
                   "specific energy  20224 psi",
                   "imbalance        4.900 % of the weight on bit, azimuth -77 deg",
                   "diagnosis        steady; means over 3 revolutions"}));
  EXPECT_EQ(volume_text(1e-3, AnswerUnits::field), "61.0237 in3");
  EXPECT_EQ(volume_text(1e-3, AnswerUnits::metric), "1000.0000 cm3");
}

TEST(Answer, of_means_that_drift_says_so) {
  RunSummary s = drilled();
  s.steady = means_over(1.0, false);
  EXPECT_EQ(answer_lines(s, AnswerUnits::metric).back(),
            "diagnosis        no vibrations; means over 1 revolution, not steady yet");
  s.drive.reset();
  s.steady = means_over(0.4, {});
  EXPECT_EQ(answer_lines(s, AnswerUnits::metric).back(),
            "diagnosis        prescribed motion; means over 0.4 revolutions, too few for a test of "
            "steadiness");
}

TEST(Answer, of_a_run_without_a_diagnosis_says_why) {
  RunSummary s = drilled();
  s.diagnosis.text = "";
  s.steady = means_over(0.002, {});
  EXPECT_EQ(
      answer_lines(s, AnswerUnits::metric).back(),
      "diagnosis        none, the run is too short; means over 0.002 revolutions, too few for "
      "a test of steadiness");
}

TEST(Answer, of_a_bit_that_neither_carries_weight_nor_advances_has_no_ratios) {
  RunSummary s = drilled();
  s.loads->wob.mean = s.loads->rop.mean = 0.0;
  s.set_weight.reset();
  const Lines lines = answer_lines(s, AnswerUnits::metric);
  EXPECT_EQ(lines[0], "weight on bit    0.000 +- 0.011 kN");
  EXPECT_EQ(lines[3], "specific energy  not defined: the bit does not advance");
  EXPECT_EQ(lines[4], "imbalance        not defined: the bit carries no weight");
}

TEST(Answer, without_forces_or_means_is_the_reason) {
  EXPECT_EQ(answer_lines({}, AnswerUnits::metric),
            Lines{"forces           not computed: the case has no table [forces]"});
  RunSummary s = drilled();
  s.loads->steps = 0;
  EXPECT_EQ(answer_lines(s, AnswerUnits::metric),
            Lines{"means            none: the run ended before output.means_from"});
}

TEST(HalfWidth, decides_the_decimals_of_a_value) {
  EXPECT_EQ(with_half_width(30.0098, 0.0109), "30.010 +- 0.011");
  EXPECT_EQ(with_half_width(30.0098, 4.2), "30.0 +- 4.2");
  EXPECT_EQ(with_half_width(-1234.5, 42.0), "-1234 +- 42");
  EXPECT_EQ(with_half_width(139.44), "139.4");
  EXPECT_EQ(with_half_width(0.0), "0.000");
  EXPECT_EQ(with_half_width(36.0, 1e-9), "36.00") << "a prescribed rate has rounding alone";
}

}  // namespace tdbd::simulation::answer_test

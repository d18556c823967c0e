#include <gtest/gtest.h>

#include "calibration/fit/problem.hpp"
#include "calibration/made_up_laboratory.hpp"

namespace tdbd::calibration::sample_test {
namespace {

Loads loads_of(const CalibrationCase& c, const Record& r) {
  const CutRun run = made_up_run(made_up_bits()[1], depth_of_run(r));
  forces::HansonHansen law = hidden_law();
  law.pressure_share = 1.0;
  return mean_loads(law, sample_of(run, r, strength_of(c.rock, r), law));
}

TEST(Sample, loads_scale_with_the_strength_between_pressures) {
  const CalibrationCase c = made_up_case();
  Record low = c.records.rows.front(), high = low;
  high.pressure = 2.0 * low.pressure;
  const Loads at_low = loads_of(c, low), at_high = loads_of(c, high);
  const double ratio = strength_of(c.rock, high).confined / strength_of(c.rock, low).confined;
  EXPECT_GT(ratio, 1.2);
  constexpr double rounding = 1e-15;
  for (const std::size_t k : {axial, turning})
    EXPECT_NEAR(at_high[k] / at_low[k], ratio, rounding * ratio);
}

/// At the same depth; what is left is the fading of forces at slow parts near the axis.
TEST(Sample, rotary_speed_carries_no_information) {
  const CalibrationCase c = made_up_case();
  Record fast = c.records.rows.front(), slow = fast;
  slow.speed = 0.5 * fast.speed;
  slow.rate = 0.5 * fast.rate;
  const Loads at_fast = loads_of(c, fast), at_slow = loads_of(c, slow);
  for (const std::size_t k : {axial, turning}) EXPECT_NEAR(at_slow[k] / at_fast[k], 1.0, 4.5e-5);
}

/// The slope that the rate's error is weighed with is that of the made-up cuts whose areas grow.
TEST(Sample, depth_slopes_are_below_one_for_a_blunt_bit) {
  const CalibrationCase c = made_up_case();
  const Record& r = c.records.rows.front();
  const Sample s = sample_of(made_up_run(made_up_bits()[1], depth_of_run(r)), r,
                             strength_of(c.rock, r), hidden_law());
  for (const double slope : depth_slopes(hidden_law(), s)) {
    EXPECT_GT(slope, 0.2);
    EXPECT_LT(slope, 1.0);
  }
}

/// Faces alone whose wear flats grow with the depth: area and depth count, so that loads go as the depth.
TEST(Sample, depth_slopes_are_one_where_a_flat_grows_with_the_depth) {
  const CalibrationCase c = made_up_case();
  const Record& r = c.records.rows.front();
  Sample s = sample_of(made_up_run(made_up_bits()[1], depth_of_run(r)), r, strength_of(c.rock, r),
                       hidden_law());
  std::erase_if(s.cuts, [](const forces::PartCut& cut) { return cut.kind != bit::PartKind::face; });
  ASSERT_FALSE(s.cuts.empty());
  const forces::Detournay growing{
      .eps = 50e6, .zeta = 0.6, .sigma = 40e6, .mu = 0.5, .l = 1.0, .kappa = 5.0};
  for (const double slope : depth_slopes(growing, s)) EXPECT_NEAR(slope, 1.0, 1e-8);
}

}  // namespace
}  // namespace tdbd::calibration::sample_test

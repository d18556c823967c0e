#include "sweep/curve/rate_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "sweep/curve/curve.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::sweep::rate_search_test {

struct Searched {
  RateProposal last;
  std::vector<RatePoint> points;
  int runs = 0;
};

/// Runs a search on a bit whose rate is a function of the weight.
Searched searched(const std::function<double(double)>& rate_of, const RateGoal& goal,
                  std::vector<RatePoint> points = {}, int most = 40) {
  Searched s{{}, std::move(points), 0};
  for (; s.runs < most; ++s.runs) {
    s.last = next_weight(s.points, goal);
    if (s.last.step != SearchStep::run) break;
    s.points.push_back({s.last.weight, rate_of(s.last.weight), 0.0});
    std::ranges::sort(s.points, {}, &RatePoint::weight);
  }
  return s;
}

/// Rates that grow with a power of the weight above a threshold. The first weight may be wrong by a
/// factor of ten.
RC_GTEST_PROP(RateSearch, finds_the_weight_of_any_growing_law, ()) {
  const double power = *battery::number(0.5, 2.0), threshold = *battery::number(0.0, 10e3);
  const double answer = threshold + *battery::number(2e3, 50e3),
               rate = *battery::number(1e-4, 1e-2);
  const auto rate_of = [&](double weight) {
    return weight > threshold ? rate * std::pow((weight - threshold) / (answer - threshold), power)
                              : 0.0;
  };
  const RateGoal goal{rate, 0.02, answer * *battery::number(0.1, 10.0)};
  const Searched s = searched(rate_of, goal);
  RC_ASSERT(s.last.step == SearchStep::found);
  RC_ASSERT(std::abs(rate_of(s.points[s.last.point].weight) / rate - 1.0) <= 0.02);
  RC_ASSERT(s.runs <= 24);
}

/// A sharp bit has a rate proportional to its weight: the second run has it.
TEST(RateSearch, of_a_proportional_law_takes_two_runs) {
  const Searched s = searched([](double weight) { return 2e-7 * weight; }, {4e-3, 0.02, 10e3});
  ASSERT_EQ(s.last.step, SearchStep::found);
  EXPECT_EQ(s.runs, 2);
  EXPECT_EQ(s.points[s.last.point].weight, 20e3);
}

TEST(RateSearch, reports_a_rate_that_falls_beyond_its_intervals) {
  const RateGoal goal{5.0, 0.02, 1.0};
  EXPECT_EQ(next_weight(std::vector<RatePoint>{{1, 1, 0}, {2, 4, 0}, {3, 3, 0}}, goal).step,
            SearchStep::falls);
  EXPECT_EQ(next_weight(std::vector<RatePoint>{{1, 1, 0}, {2, 4, 0}, {3, 3, 0}}, goal).point, 1u);
  EXPECT_EQ(next_weight(std::vector<RatePoint>{{1, 1, 0}, {2, 4, 0.6}, {3, 3, 0.6}}, goal).step,
            SearchStep::run);
}

/// A jump of the rate has no weight in between.
TEST(RateSearch, ends_at_a_jump) {
  const Searched s = searched([](double w) { return w < 12345.0 ? 1.0 : 3.0; }, {2.0, 0.02, 10e3},
                              {{10e3, 1.0, 0.0}, {20e3, 3.0, 0.0}}, 200);
  EXPECT_EQ(s.last.step, SearchStep::unresolved);
  EXPECT_TRUE(is_within_reach(s.points, 2.0));
  EXPECT_FALSE(is_within_reach(s.points, 3.5));
}

TEST(RateSearch, extrapolates_in_both_directions_within_limits) {
  const std::vector<RatePoint> points{{10e3, 1.0, 0.0}, {20e3, 2.0, 0.0}};
  EXPECT_EQ(next_weight(points, {3.0, 0.02, 0.0}).weight, 30e3);
  EXPECT_EQ(next_weight(points, {9.0, 0.02, 0.0}).weight, 50e3);
  EXPECT_EQ(next_weight(points, {0.7, 0.02, 0.0}).weight, 7e3);
  EXPECT_EQ(next_weight(points, {0.1, 0.02, 0.0}).weight, 4e3);
}

TEST(RateSearch, rounds_weights_to_four_digits) {
  EXPECT_EQ(four_digits(21437.4), 21440.0);
  EXPECT_EQ(four_digits(1.23456), 1.235);
  EXPECT_EQ(four_digits(99999.0), 100000.0);
}

std::string refusal(const std::string& name, const std::vector<std::string>& settings = {}) {
  try {
    require_weight_driven(simulation::read_case(TDBD_SOURCE_DIR "/cases/" + name, settings));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Curve, requires_a_case_whose_weight_is_set) {
  EXPECT_EQ(refusal("drill-bit-b.toml"), "");
  const std::string expected =
      "expected kind = \"drilling\" with one weight_on_bit, which the curve varies; where the rate "
      "is set, the weight is a result that tdbd run prints";
  EXPECT_NE(refusal("bit-b-6000psi.toml").find("motion: found a prescribed motion, " + expected),
            std::string::npos)
      << refusal("bit-b-6000psi.toml");
  EXPECT_NE(
      refusal("string-drill-bit-b.toml").find("motion: found a bit that is lowered at a rate, "),
      std::string::npos);
  EXPECT_NE(
      refusal("drill-bit-b.toml", {"motion.weight_on_bit={ times = [0, 1], values = [1e4, 2e4] }"})
          .find("motion: found a weight_on_bit that changes over time, "),
      std::string::npos);
}

Curve curve_of(RateEnd end) {
  Curve curve{"shale",
              {{.weight_set = 10e3, .rop = 5.0 / 3600}, {.weight_set = 20e3, .rop = 9.0 / 3600}},
              end,
              0,
              2};
  for (CurvePoint& p : curve.points) p.rop_interval = 0.1 / 3600;
  return curve;
}

TEST(Curve, states_how_the_search_ended) {
  const CurvePlan plan{.rate = 15.0 / 3600};
  EXPECT_EQ(rate_text(plan, curve_of(RateEnd::out_of_reach)),
            "shale: 15 m/h is out of reach; the largest rate found is 9 m/h at 20 kN, the smallest "
            "5 m/h at 10 kN");
  EXPECT_EQ(rate_text(plan, curve_of(RateEnd::found)),
            "shale: 15 m/h takes 10 kN (found 5 +- 0.1 m/h after 2 runs)");
  Curve drifting = curve_of(RateEnd::found);
  drifting.points.front().steady = Steady::no;
  EXPECT_EQ(rate_text(plan, drifting),
            "shale: 15 m/h takes 10 kN (found 5 +- 0.1 m/h after 2 runs; its means are not steady: "
            "run longer)");
  const std::string rates = rates_csv(plan, {.curves = {drifting}});
  EXPECT_NE(rates.find("rop_interval_m_per_h,steady,message\n"), std::string::npos) << rates;
  EXPECT_NE(rates.find(",no,"), std::string::npos) << rates;
  EXPECT_NE(
      rate_text(plan, curve_of(RateEnd::falls)).find("falls from 5 m/h at 10 kN to 9 m/h at "),
      std::string::npos);
}

}  // namespace tdbd::sweep::rate_search_test

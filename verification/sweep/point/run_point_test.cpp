#include "sweep/point/run_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::sweep::figures_test {

const nlohmann::ordered_json summary{{"steps", 12},
                                     {"mean", nullptr},
                                     {"met", true},
                                     {"name", "bit"},
                                     {"inner", {{"deep", {{{"x", 1.5}}, {{"x", 2.5}}}}}}};

TEST(Figures, are_numbers_at_any_depth) {
  EXPECT_EQ(figure_names(summary),
            (std::vector<std::string>{"steps", "mean", "met", "inner.deep.0.x", "inner.deep.1.x"}));
  const std::vector<double> found = summarize(summary, {"inner.deep.1.x", "steps", "met", "mean"});
  EXPECT_EQ(found[0], 2.5);
  EXPECT_EQ(found[1], 12.0);
  EXPECT_EQ(found[2], 1.0);
  EXPECT_TRUE(std::isnan(found[3]));
}

TEST(Figures, that_are_none_are_named_with_the_nearest) {
  try {
    summarize(summary, {"step", "name", "steps"});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "sweep.figures: found step, expected a number of the summary, such as steps\n"
                 "sweep.figures: found name, expected a number of the summary");
  }
}

}  // namespace tdbd::sweep::figures_test

namespace tdbd::sweep::planar_test {

simulation::Case case_with(const std::string& name, std::vector<std::string> settings) {
  settings.emplace_back("rock.edge_length='5 mm'");
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/" + name, settings);
}

/// 15 m/h at 120 rpm are 15 m in 7200 revolutions; all that the bit sinks is cut, from a core of half a
/// millimetre to its rim.
TEST(Planar, cuts_as_deep_as_the_bit_sinks_in_a_revolution) {
  const simulation::Case c = case_with("bit-b-steady.toml", {"motion.rate_of_penetration='15 m/h'",
                                                             "motion.rotary_speed='120 rpm'"});
  const auto found = planar_summary(c, 0.8);
  const double advance = 15.0 / 7200.0;
  EXPECT_NEAR(found["advance_m"], advance, 1e-17);
  EXPECT_LT(found["cut_area_m2"], advance * c.bit.gage_radius);
  EXPECT_GT(found["cut_area_m2"], advance * (c.bit.gage_radius - 0.5e-3));
  EXPECT_GE(found["engaged_cutters"], 22);
  EXPECT_LE(found["engaged_cutters"], c.bit.cutters.size());
  EXPECT_LT(found["largest_cut_area_m2"], found["cut_area_m2"]);
  EXPECT_GE(found["mean_redundancy"], 1.0);
}

/// Half the normal force is half the weight on bit that the side force is divided by.
TEST(Planar, imbalance_of_drag_alone_goes_with_one_over_the_normal_forces) {
  const simulation::Case c = case_with("bit-b-steady.toml", {});
  const auto imbalance = [&](double ratio) -> double {
    return planar_summary(c, ratio)["imbalance"];
  };
  EXPECT_NEAR(imbalance(1e-7) / imbalance(2e-7), 2.0, 8e-9);
  EXPECT_LT(imbalance(0.8), imbalance(0.4));
}

TEST(Planar, rejects_teeth_and_a_bit_at_rest) {
  EXPECT_THROW(planar_summary(case_with("bit-r-steady.toml", {}), 0.8), InputError);
  const simulation::Case still = case_with("bit-b-steady.toml", {"motion.rate_of_penetration=0"});
  EXPECT_THROW(planar_summary(still, 0.8), InputError);
}

}  // namespace tdbd::sweep::planar_test

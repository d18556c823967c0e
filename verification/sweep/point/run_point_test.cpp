#include "sweep/point/run_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

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

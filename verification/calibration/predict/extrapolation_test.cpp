#include <gtest/gtest.h>

#include "calibration/made_up_laboratory.hpp"
#include "calibration/predict/prediction.hpp"

namespace tdbd::calibration::extrapolation_test {
namespace {

TEST(Extrapolation, is_told_of_rakes_diameters_and_pressures_beyond_the_fit) {
  const CalibrationCase c = made_up_case();
  const CutStore cuts = made_up_cuts(c);
  const auto samples = [&](const std::vector<std::string>& names) {
    std::vector<Sample> all;
    for (const Record& r : records_of(c, names))
      all.push_back(sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), c.law));
    return all;
  };
  EXPECT_TRUE(extrapolations(samples({"B", "C"}), samples({"A"})).empty());
  const std::vector<std::string> found = extrapolations(samples({"A", "B"}), samples({"C"}));
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found[0].rfind("mean back rake: ", 0), 0u) << found[0];
  EXPECT_EQ(found[1], "cutter diameter: 13 to 13 mm predicted, 16 to 19 mm fitted");
  std::vector<Sample> deeper = samples({"A"});
  for (Sample& s : deeper)
    for (forces::PartCut& cut : s.cuts) cut.strength.pressure *= 2.0;
  EXPECT_EQ(
      extrapolations(samples({"B", "C"}), deeper),
      (std::vector<std::string>{"pressure: 41.4 to 82.7 MPa predicted, 20.7 to 41.4 MPa fitted"}));
}

}  // namespace
}  // namespace tdbd::calibration::extrapolation_test

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

/// Two faces of areas 1 and 3, and a chamfer that cuts nothing.
Sample sample_with(double rake, double diameter, double depth, double pressure) {
  Sample s;
  for (const double area : {1e-6, 3e-6, 0.0}) {
    forces::PartCut& cut = s.cuts.emplace_back();
    const double off = area == 0.0 ? 5.0 : area == 1e-6 ? 1.3 : 0.9;  // their mean is 1
    cut.cut_area = area;
    cut.back_rake = off * rake;
    cut.diameter = off * diameter;
    cut.depth = off * depth;
    cut.strength.pressure = pressure;
  }
  return s;
}

/// Means are weighted by the area that the faces cut. Exceeding the largest value by a hundredth is
/// no extrapolation, by two hundredths it is, on either side, and each quantity is reported with
/// its name.
TEST(Extrapolation, is_told_of_means_by_area_beyond_a_hundredth) {
  const double rake = 20.0 * pi / 180.0;
  const std::vector<Sample> fitted{sample_with(0.5 * rake, 8e-3, 0.5e-3, 10e6),
                                   sample_with(rake, 16e-3, 1e-3, 20e6)};
  for (const double share : {1.009, 0.491})
    EXPECT_TRUE(extrapolations(
                    fitted, {sample_with(share * rake, share * 16e-3, share * 1e-3, share * 20e6)})
                    .empty());
  EXPECT_EQ(extrapolations(fitted, {sample_with(1.05 * rake, 1.05 * 16e-3, 1.05e-3, 21e6)}),
            (std::vector<std::string>{
                "mean back rake: 21 to 21 deg predicted, 10 to 20 deg fitted",
                "cutter diameter: 16.8 to 16.8 mm predicted, 8 to 16 mm fitted",
                "thickness of the cut: 1.05 to 1.05 mm predicted, 0.5 to 1 mm fitted",
                "pressure: 21 to 21 MPa predicted, 10 to 20 MPa fitted"}));
  EXPECT_EQ(extrapolations(fitted, {sample_with(0.45 * rake, 10e-3, 0.45e-3, 15e6),
                                    sample_with(0.6 * rake, 12e-3, 0.6e-3, 15e6)}),
            (std::vector<std::string>{
                "mean back rake: 9 to 12 deg predicted, 10 to 20 deg fitted",
                "thickness of the cut: 0.45 to 0.6 mm predicted, 0.5 to 1 mm fitted"}));
  EXPECT_TRUE(extrapolations({}, fitted).empty());
  EXPECT_TRUE(extrapolations(fitted, {}).empty());
}

}  // namespace
}  // namespace tdbd::calibration::extrapolation_test

#include "bit/report/overlap_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tdbd::bit::overlap_report_test {

Bit three_cutters() {
  Bit bit;
  for (const int id : {4, 7, 9}) bit.cutters.emplace_back().id = id;
  return bit;
}

TEST(OverlapReport, sums_the_pairs_and_names_the_worst) {
  const Bit bit = three_cutters();
  const std::vector<CutterOverlap> pairs{{0, 1, 2e-9}, {1, 2, 5e-9}};
  const auto json = overlaps_json(bit, pairs);
  EXPECT_DOUBLE_EQ(json.at("volume_m3").get<double>(), 7e-9);
  EXPECT_EQ(json.at("pairs").size(), 2U);
  EXPECT_EQ(json.at("pairs")[1].at("a"), "cutter-7");
  EXPECT_EQ(json.at("pairs")[1].at("b"), "cutter-9");
  const std::string text = overlaps_text(bit, pairs);
  EXPECT_NE(text.find("2 pairs of cutters overlap by 7.0 mm3"), text.npos) << text;
  EXPECT_NE(text.find("5.0 mm3, cutters 7 and 9"), text.npos) << text;
  EXPECT_EQ(overlaps_text(bit, {}), "");
}

}  // namespace tdbd::bit::overlap_report_test

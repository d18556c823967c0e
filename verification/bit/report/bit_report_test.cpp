#include "bit/report/bit_report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/generate.hpp"

namespace tdbd::bit::bit_report_test {

nlohmann::json analysis_of(const Bit& bit) {
  const std::filesystem::path folder = test_folder();
  write_analysis(folder, bit, {});
  return nlohmann::json::parse(std::ifstream(folder / "analysis.json"));
}

Vec3 vector_of(const nlohmann::json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

TEST(BitReport, has_the_axes_of_every_cutter) {
  std::vector<Cutter> three = table('b');
  three.resize(3);
  const Bit bit = pdc_bit("three", three, {});
  const nlohmann::json cutters = analysis_of(bit).at("cutters");
  ASSERT_EQ(cutters.size(), bit.cutters.size());
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    const Pose& X_BC = bit.cutters[k].X_BC;
    EXPECT_EQ(vector_of(cutters[k].at("face_centre_m")), X_BC.p);
    EXPECT_EQ(vector_of(cutters[k].at("x_axis")), X_BC.R.col(0));
    EXPECT_EQ(vector_of(cutters[k].at("y_axis")), X_BC.R.col(1));
    EXPECT_EQ(vector_of(cutters[k].at("z_axis")), X_BC.R.col(2));
  }
}

/// Cones with their rows, their tracking and what is assumed of them; none of a bit without.
TEST(BitReport, has_cones_where_the_bit_has_some) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const nlohmann::json a = analysis_of(bit);
  ASSERT_EQ(a.at("cones").size(), bit.cones.size());
  EXPECT_EQ(a.at("cones")[0].at("rows").size(), bit.cones[0].layout.rows.size());
  EXPECT_TRUE(a.contains("tracking"));
  std::vector<Cutter> three = table('b');
  three.resize(3);
  const nlohmann::json without = analysis_of(pdc_bit("three", three, {}));
  EXPECT_FALSE(without.contains("cones"));
  EXPECT_FALSE(without.contains("tracking"));
}

}  // namespace tdbd::bit::bit_report_test

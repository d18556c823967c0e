#include "bit/files/bit_export.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_rolling.hpp"
#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"

namespace tdbd::bit::bit_export_test {

namespace fs = std::filesystem;

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";
const std::string bit_r = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";

/// A bit, written to a folder in a format and read back.
std::string exported(const fs::path& folder, const std::string& format,
                     const std::string& bit_file = bit_b) {
  export_bit(folder, read(bit_file), format);
  return (folder / "bit.toml").string();
}

void expect_same_but_for_rounding(const Bit& a, const Bit& b, double rounding) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_NEAR(a.gage_radius, b.gage_radius, rounding);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const Part &p = a.parts[i], &q = b.parts[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.cutting, q.cutting);
    EXPECT_EQ(p.group, q.group);
    EXPECT_EQ(p.density, q.density);
    EXPECT_LE((p.update_direction_B - q.update_direction_B).norm(), 1e-14) << p.name;
    EXPECT_LE((p.X_BP.R - q.X_BP.R).norm(), 1e-14) << p.name;
    EXPECT_LE((p.X_BP.p - q.X_BP.p).norm(), 1e-16) << p.name;
    EXPECT_EQ(p.mesh_P.triangles.size(), q.mesh_P.triangles.size()) << p.name;
  }
}

TEST(BitExport, reads_back_with_every_bit_of_the_coordinates) {
  const Bit original = read(bit_b);
  for (const char* format : {"ply", "off", "obj"}) {
    const Bit again = read(exported(test_folder(), format));
    expect_same_but_for_rounding(original, again, 1e-16);
    for (std::size_t i = 0; i < original.parts.size(); ++i)
      EXPECT_EQ(original.parts[i].mesh_P.positions, again.parts[i].mesh_P.positions) << format;
  }
}

TEST(BitExport, reads_back_from_single_precision) {
  expect_same_but_for_rounding(read(bit_b), read(exported(test_folder(), "stl")), 1e-8);
}

TEST(BitExport, reads_back_with_cones_that_turn) {
  const Bit original = read(bit_r), again = read(exported(test_folder(), "stl", bit_r));
  ASSERT_EQ(again.cones.size(), 3u);
  const std::vector<double> angles{0.3, -20.0, 1e-3};
  expect_same_but_for_rounding(turned(original, angles), turned(again, angles), 1e-15);
  for (std::size_t i = 0; i < original.parts.size(); ++i) {
    EXPECT_EQ(original.parts[i].cone, again.parts[i].cone);
    const auto &there = original.parts[i].mesh_P.positions, &here = again.parts[i].mesh_P.positions;
    if (!original.parts[i].name.starts_with("leg-")) {
      EXPECT_EQ(there, here);
      continue;
    }
    ASSERT_EQ(there.size(), here.size());  // legs follow the cones, settled on the bottom once more
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_LT((there[k] - here[k]).norm(), 1e-14);
  }
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(rolling_ratio_of_gage_row(original.cones[k]),
              rolling_ratio_of_gage_row(again.cones[k]));
}

TEST(BitExport, writes_the_exposure_profile) {
  const fs::path folder = test_folder();
  write_profile(folder, read(bit_b));
  std::ifstream in(folder / "profile.csv");
  std::string line, last;
  std::getline(in, line);
  EXPECT_EQ(line, "r_m,z_m");
  while (std::getline(in, line)) last = line;
  EXPECT_NEAR(std::stod(last), read(bit_b).gage_radius, 2.8e-6);
}

}  // namespace tdbd::bit::bit_export_test

#include "bit/report/bit_output.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/generate.hpp"
#include "bit/report/cone_report.hpp"
#include "bit/report/overlap_report.hpp"
#include "core/read_file.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::bit_output_test {
namespace {

nlohmann::json bit_json(const Bit& bit) {
  const std::filesystem::path folder = test_folder();
  write_bit_files(folder, bit);
  return nlohmann::json::parse(read_file(folder / "bit.json", "a bit"));
}

/// Each number of a cutter under its own key; cones where there are some.
TEST(BitJson, has_every_number_of_every_cutter) {
  std::vector<Cutter> three = table('b');
  three.resize(3);
  for (Cutter& c : three) c.side_rake = 0.02 * c.id;
  const Bit bit = pdc_bit("three", three, {});
  const nlohmann::json found = bit_json(bit);
  EXPECT_EQ(found.at("schema"), 1);
  EXPECT_EQ(found.at("name"), "three");
  EXPECT_EQ(found.at("gage_radius_m"), bit.gage_radius);
  EXPECT_FALSE(found.contains("cones"));
  const std::vector<std::pair<const char*, double Cutter::*>> keys{
      {"tip_radius_m", &Cutter::tip_radius}, {"azimuth_rad", &Cutter::azimuth},
      {"tip_height_m", &Cutter::tip_height}, {"profile_angle_rad", &Cutter::profile_angle},
      {"back_rake_rad", &Cutter::back_rake}, {"side_rake_rad", &Cutter::side_rake},
      {"diameter_m", &Cutter::diameter},     {"chamfer_m", &Cutter::chamfer}};
  ASSERT_EQ(found.at("cutters").size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const nlohmann::json& cutter = found.at("cutters")[k];
    for (const auto& [key, number] : keys) EXPECT_EQ(cutter.at(key), bit.cutters[k].*number) << key;
    EXPECT_EQ(cutter.at("name"), "cutter-" + std::to_string(bit.cutters[k].id));
    EXPECT_EQ(cutter.at("blade"), bit.cutters[k].blade);
    EXPECT_EQ(cutter.at("zone"), bit.cutters[k].zone);
  }
}

TEST(BitJson, has_the_cones_of_a_bit_with_some) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const nlohmann::json found = bit_json(bit);
  EXPECT_EQ(found.at("cones"), nlohmann::json(cones_json(bit)));
  EXPECT_EQ(found.at("cutters").size(), 0U);
}

/// Three boxes apart, of which the second and third belong to a cutter and a cone.
Bit boxes() {
  Bit bit;
  for (int i = 0; i < 3; ++i) {
    Part& part = bit.parts.emplace_back();
    part.name = "box-" + std::to_string(i + 1);
    part.mesh_P = battery::box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
    part.X_BP.p = Vec3(3.0 * i, 0.0, 0.0);
    part.density = 1.0;
  }
  bit.parts[1].kind = PartKind::face;
  bit.parts[1].cutter = 7;
  bit.parts[2].kind = PartKind::cone;
  bit.parts[2].cone = 0;
  return bit;
}

TEST(MergedMesh, has_every_part_in_its_place_and_tells_whose_a_triangle_is) {
  const Bit bit = boxes();
  const Pose X_WB{Eigen::AngleAxisd(0.7, Vec3(0.6, 0.0, 0.8)).toRotationMatrix(), Vec3(1, 2, 3)};
  std::vector<int> owner;
  const mesh::TriangleMesh all = merged_mesh(bit, X_WB, &owner);
  ASSERT_EQ(owner.size(), all.triangles.size());
  std::size_t t = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const mesh::Triangle& own : bit.parts[i].mesh_P.triangles) {
      EXPECT_EQ(owner[t], static_cast<int>(i));
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 place = X_WB * (bit.parts[i].X_BP *
                                   bit.parts[i].mesh_P.positions[static_cast<std::size_t>(own[k])]);
        EXPECT_EQ(all.positions[static_cast<std::size_t>(all.triangles[t][k])], place);
      }
      ++t;
    }
  EXPECT_EQ(t, all.triangles.size());
  EXPECT_EQ(merged_mesh(bit, X_WB, nullptr).triangles, all.triangles);
}

/// Part, kind and cutter of every triangle; the cone where the bit has some. Small whole numbers fill their bytes.
TEST(BitVtp, names_the_fields_of_its_triangles) {
  Bit bit = boxes();
  const std::filesystem::path file = test_folder() / "bit.vtp";
  const auto text = [&] {
    write_bit_vtp(file, bit, Pose{});
    return read_file(file, "a bit");
  };
  const std::string without = text();
  for (const char* name : {"\"part\"", "\"kind\"", "\"cutter\""})
    EXPECT_NE(without.find(name), std::string::npos) << name;
  EXPECT_EQ(without.find("\"cone\""), std::string::npos);
  bit.cones.emplace_back();
  EXPECT_NE(text().find("\"cone\""), std::string::npos);
}

/// A part inside another is named with what encloses it, if both are weighed.
TEST(EnclosedText, names_what_lies_inside_what) {
  Bit bit = boxes();
  EXPECT_EQ(enclosed_text(bit), "");
  bit.parts[1].mesh_P = battery::box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  bit.parts[1].X_BP.p.setZero();
  EXPECT_EQ(enclosed_text(bit),
            "warning: box-2 lies inside box-1, so its volume counts twice in the mass\n");
  bit.parts[0].density = 0.0;
  EXPECT_EQ(enclosed_text(bit), "");
}

}  // namespace
}  // namespace tdbd::bit::bit_output_test

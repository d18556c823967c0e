#include "bit/files/bit_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::bit_parts_test {

namespace fs = std::filesystem;

const mesh::TriangleMesh box = battery::box({-5, -10, -15}, {5, 10, 15});

TEST(BitParts, takes_the_settings_of_the_table) {
  const fs::path folder = test_folder();
  const Bit b = read(
      write_one_part_bit(folder, box,
                         "kind = \"tooth\"\nunit = \"1 in\"\ndensity = \"15 g/cm3\"\ngroup = 4\n"
                         "position = [\"10 mm\", 0, 0.5]\nrotation_vector = [0, 0, \"90 deg\"]\n"
                         "update_direction = [3, 0, 4]\n"));
  ASSERT_EQ(b.parts.size(), 1u);
  const Part& p = b.parts[0];
  EXPECT_EQ(p.name, "tool");
  EXPECT_EQ(p.kind, PartKind::tooth);
  EXPECT_EQ(p.cutting, Cutting::cuts);
  EXPECT_EQ(p.group, 4);
  EXPECT_DOUBLE_EQ(p.density, 15e3);
  EXPECT_NEAR((p.X_BP * Vec3(1, 0, 0) - Vec3(0.01, 1, 0.5)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((p.update_direction_B - Vec3(0.6, 0, 0.8)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(b.gage_radius, std::hypot(5 * 0.0254, 10 * 0.0254 + 0.01), 1e-12);
  EXPECT_EQ(p.mesh_P.triangles.size(), box.triangles.size());
}

TEST(BitParts, is_in_millimetres_and_in_the_bit_frame_by_default) {
  const Bit b = read(write_one_part_bit(test_folder(), box, "kind = \"gage-pad\"\n"));
  EXPECT_EQ(b.parts[0].X_BP.R, Mat3(Mat3::Identity()));
  EXPECT_EQ(b.parts[0].update_direction_B, Vec3(1, 0, 0));
  EXPECT_DOUBLE_EQ(b.gage_radius, 5e-3 * std::sqrt(5.0));
  EXPECT_EQ(b.parts[0].density, 0.0);
}

/// The direction of a cutter's part follows from its frame, by the rule that the case chooses.
TEST(BitParts, derives_a_cutters_direction_from_its_frame) {
  const std::string file = write_one_part_bit(
      test_folder(), box,
      "kind = \"face\"\nposition = [\"50 mm\", 0, 0]\nrotation_vector = [0, \"-120 deg\", 0]\n");
  const Vec3 outside(std::sin(120 * M_PI / 180), 0, 0.5);
  EXPECT_NEAR((read(file).parts[0].update_direction_B - outside).norm(), 0.0, 1e-12);
  EXPECT_EQ(read(file, DirectionRule::all_down).parts[0].update_direction_B, Vec3(0, 0, 1));
}

/// A cylinder has a flat profile below and a wall beside it.
TEST(BitParts, takes_a_cutters_direction_from_the_profile_without_a_frame) {
  const fs::path folder = test_folder();
  mesh::write_mesh(folder / "cylinder.off", battery::cylinder(50, 40, 64));
  mesh::write_mesh(folder / "side.off", battery::box({49, -1, 8}, {51, 1, 12}));
  const auto direction = [&](const std::string& rule) {
    return read(write_file(folder / "bit.toml", R"(name = "walled"
[[parts]]
name = "cylinder"
kind = "bit-body"
file = "cylinder.off"
cutting = true
[[parts]]
name = "side"
kind = "cutter-body"
file = "side.off"
)" + rule))
        .parts[1]
        .update_direction_B;
  };
  EXPECT_GT(direction("").x(), 0.9);
  EXPECT_EQ(direction("update_direction = [0, 0, 2]\n"), Vec3(0, 0, 1));
}

TEST(BitParts, lets_a_bit_body_cut_only_on_request) {
  const fs::path folder = test_folder();
  expect_words(complaint(write_one_part_bit(folder, box, "kind = \"bit-body\"\n")),
               {"parts: found no part that cuts"});
  EXPECT_EQ(complaint(write_one_part_bit(folder, box, "kind = \"bit-body\"\ncutting = true\n")),
            "");
}

TEST(BitParts, names_the_missing_file) {
  const fs::path folder = test_folder();
  const std::string file = write_one_part_bit(folder, box, "kind = \"tooth\"\n");
  fs::remove(folder / "part.ply");
  expect_words(complaint(file), {"bit.toml:4: parts[0].file:", "there is no", "part.ply"});
}

TEST(BitParts, reports_a_part_without_a_file_once) {
  const std::string message =
      complaint(write_file(test_folder() / "bit.toml",
                           "name = \"tool\"\n[[parts]]\nname = \"tool\"\nkind = \"tooth\"\n"));
  const std::size_t first = message.find("parts[0].file: found nothing");
  ASSERT_NE(first, std::string::npos) << message;
  EXPECT_EQ(message.find("parts[0]", first + 1), std::string::npos) << message;
}

TEST(BitParts, rejects_what_is_no_mesh) {
  const fs::path folder = test_folder();
  const std::string file = write_one_part_bit(folder, box, "kind = \"tooth\"\n");
  write_file(folder / "part.ply", "this is no mesh");
  expect_words(complaint(file), {"bit.toml:4: parts[0].file:", "part.ply", "closed mesh"});
}

TEST(BitParts, rejects_a_hole) {
  mesh::TriangleMesh open = box;
  open.triangles.pop_back();
  expect_words(complaint(write_one_part_bit(test_folder(), open, "kind = \"tooth\"\n")),
               {"bit.toml:4: parts[0].file:", "part.ply", "hole"});
}

TEST(BitParts, rejects_a_flipped_facet) {
  mesh::TriangleMesh flipped = box;
  std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
  expect_words(complaint(write_one_part_bit(test_folder(), flipped, "kind = \"tooth\"\n")),
               {"bit.toml:4: parts[0].file:", "part.ply", "flipped triangle"});
}

TEST(BitParts, rejects_a_mesh_that_is_inside_out) {
  mesh::TriangleMesh inverted = box;
  for (mesh::Triangle& t : inverted.triangles) std::swap(t[0], t[1]);
  expect_words(complaint(write_one_part_bit(test_folder(), inverted, "kind = \"tooth\"\n")),
               {"bit.toml:4: parts[0].file:", "inside out"});
}

TEST(BitParts, rejects_an_edge_of_four_facets) {
  mesh::TriangleMesh twice = box;
  twice.triangles.insert(twice.triangles.end(), box.triangles.begin(), box.triangles.end());
  expect_words(complaint(write_one_part_bit(test_folder(), twice, "kind = \"tooth\"\n")),
               {"bit.toml:4: parts[0].file:", "edge of more than two triangles"});
}

TEST(BitParts, lists_every_mistake_at_its_line) {
  const fs::path folder = test_folder();
  mesh::write_mesh(folder / "box.off", box);
  const std::string message = complaint(write_file(folder / "bit.toml", R"(name = "many"
table = "cutters.csv"
[[parts]]
name = "a b"
kind = "toth"
file = "box.off"
colour = "red"
[[parts]]
name = "pad"
kind = "gage-pad"
file = "box.off"
group = 1
update_direction = [0, 1, 0]
[[parts]]
name = "pad"
kind = "gage-pad"
file = "box.off"
group = 1
position = [0, 0, 1]
)"));
  EXPECT_EQ(message.find("table", message.find("table") + 5), std::string::npos) << message;
  expect_words(message, {"bit.toml:2: table: found parts as well",
                         "bit.toml:4: parts[0].name: found \"a b\"", "did you mean tooth?",
                         "bit.toml:7: parts[0].colour: found an unknown key",
                         "bit.toml:13: parts[1].update_direction: found (0, 1, 0)",
                         "bit.toml:15: parts[2].name: found \"pad\" a second time",
                         "bit.toml:18: parts[2].group: found another frame"});
}

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";
const std::string bit_r = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";

/// A bit, written to a folder in a format and read back.
std::string exported(const fs::path& folder, const std::string& format,
                     const std::string& bit_file = bit_b) {
  export_bit(folder, read(bit_file), {.parts = format});
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

/// `tdbd keys --markdown` makes the page of them and of those of cases.
TEST(BitTables, are_on_the_page_of_keys_in_its_order) {
  const std::string page = read_file(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md", "a page");
  std::size_t before = 0;
  for (const KeyTable& table : bit_tables()) {
    const std::size_t at = page.find(keys_as_markdown(std::vector{table}), before);
    EXPECT_NE(at, std::string::npos) << table.name;
    if (at != std::string::npos) before = at;
  }
}

}  // namespace tdbd::bit::bit_parts_test

#include "bit/files/solids_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "core/error.hpp"
#include "mesh/files/solids.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::solids_file_test {

namespace fs = std::filesystem;

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";

/// Corner by corner in the bit's frame.
std::vector<Vec3> corners_B(const Part& part) {
  std::vector<Vec3> all;
  for (const mesh::Triangle& t : part.mesh_P.triangles)
    for (const int v : t)
      all.push_back(part.X_BP * part.mesh_P.positions[static_cast<std::size_t>(v)]);
  return all;
}

void expect_same_part(const Part& p, const Part& q) {
  EXPECT_EQ(p.name, q.name);
  EXPECT_EQ(p.kind, q.kind) << p.name;
  EXPECT_EQ(p.cutting, q.cutting) << p.name;
  EXPECT_EQ(p.density, q.density) << p.name;
  EXPECT_EQ(p.group, q.group) << p.name;
  EXPECT_LE((p.update_direction_B - q.update_direction_B).norm(), 1e-14) << p.name;
  EXPECT_EQ(corners_B(p), corners_B(q)) << p.name;
}

class WholeBit : public ::testing::TestWithParam<const char*> {};

TEST_P(WholeBit, is_bitwise_unchanged_by_writing_and_reading) {
  const fs::path folder = fs::path(tdbd::temporary_folder()) / (std::string("whole_") + GetParam());
  fs::create_directories(folder);
  const Bit original = read(bit_b);
  export_solids(folder, original, {.solids = GetParam()});
  const Bit again = read((folder / "solids.toml").string());
  EXPECT_EQ(again.name, original.name);
  EXPECT_EQ(again.gage_radius, original.gage_radius);
  ASSERT_EQ(again.parts.size(), original.parts.size());
  for (std::size_t i = 0; i < original.parts.size(); ++i)
    expect_same_part(original.parts[i], again.parts[i]);
}

/// Of a roller cone bit: the parts turn about the same journals, and reach the same gage.
TEST_P(WholeBit, keeps_its_cones) {
  const fs::path folder = fs::path(tdbd::temporary_folder()) / (std::string("cones_") + GetParam());
  fs::create_directories(folder);
  const Bit original = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  export_solids(folder, original, {.solids = GetParam()});
  const Bit again = read((folder / "solids.toml").string());
  ASSERT_EQ(again.parts.size(), original.parts.size());
  ASSERT_EQ(again.cones.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(again.cones[k].X_BK.R, original.cones[k].X_BK.R);
    EXPECT_EQ(again.cones[k].X_BK.p, original.cones[k].X_BK.p);
  }
  for (std::size_t i = 0; i < original.parts.size(); ++i) {
    EXPECT_EQ(again.parts[i].cone, original.parts[i].cone);
    expect_same_part(original.parts[i], again.parts[i]);
  }
  EXPECT_NEAR(again.gage_radius, original.gage_radius, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Formats, WholeBit, ::testing::Values("stl", "obj", "ply", "off"));

/// A body, a cutter and a pad, in mm; what a drawing program might write.
std::vector<mesh::Solid> drawn() {
  return {{"cutter-1/face", battery::box({40, -8, 1}, {42, 8, 17})},
          {"cutter-1/body", battery::box({30, -8, 1}, {40, 8, 17})},
          {"gage-pad-1", battery::box({-50, -8, -60}, {-40, 8, -10})},
          {"bit-body", battery::cylinder(30, 60, 24)}};
}

std::string write_drawn(const std::string& rules,
                        const std::vector<mesh::Solid>& solids = drawn()) {
  mesh::write_solids(test_folder() / "bit.stl", solids);
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  return write_file(fs::path(tdbd::temporary_folder()) /
                        (std::string(info->test_suite_name()) + "_" + info->name()) / "bit.toml",
                    "name = \"drawn\"\n[solids]\nfile = \"bit.stl\"\n" + rules);
}

TEST(SolidsFile, takes_kinds_and_groups_from_names) {
  const Bit b = read(write_drawn(""));
  ASSERT_EQ(b.parts.size(), 4u);
  EXPECT_EQ(b.parts[0].kind, PartKind::face);
  EXPECT_EQ(b.parts[1].kind, PartKind::cutter_body);
  EXPECT_EQ(b.parts[2].kind, PartKind::gage_pad);
  EXPECT_EQ(b.parts[3].kind, PartKind::bit_body);
  EXPECT_EQ(b.parts[3].cutting, Cutting::never);
  EXPECT_EQ(b.parts[0].group, 0);
  EXPECT_EQ(b.parts[1].group, 0);
  EXPECT_EQ(b.parts[2].group, -1);
  EXPECT_EQ(b.parts[2].update_direction_B, Vec3(1, 0, 0));
  EXPECT_EQ(b.parts[0].update_direction_B, b.parts[1].update_direction_B);
  EXPECT_DOUBLE_EQ(b.parts[0].mesh_P.positions[0].z(), 1e-3);
  for (const Part& part : b.parts) EXPECT_EQ(part.density, 0.0);  // unless a rule sets one
}

TEST(SolidsFile, lets_no_body_of_a_cone_cut_unless_a_rule_does) {
  const std::string as_cone = "[[solids.rules]]\nmatch = \"gage-pad-1\"\nkind = \"cone\"\n";
  const auto cutting_of = [](const std::string& rules) {
    return read(write_drawn(rules)).parts[2].cutting;
  };
  EXPECT_EQ(cutting_of(""), Cutting::cuts);
  EXPECT_EQ(cutting_of(as_cone), Cutting::never);
  EXPECT_EQ(cutting_of(as_cone + "cutting = true\n"), Cutting::cuts);
}

TEST(SolidsFile, lets_what_does_not_cut_rub_if_a_rule_enables_it) {
  const auto cutting_of = [](const std::string& keys) {
    return read(write_drawn("[[solids.rules]]\nmatch = \"gage-pad-1\"\n" + keys)).parts[2].cutting;
  };
  EXPECT_EQ(cutting_of("cutting = false\n"), Cutting::never);
  EXPECT_EQ(cutting_of("cutting = false\nrubs = true\n"), Cutting::rubs);
  EXPECT_EQ(cutting_of("rubs = true\n"), Cutting::cuts);
}

/// Written out and read again.
TEST(SolidsFile, keeps_what_rubs) {
  const auto folder = test_folder();
  export_solids(folder,
                read(write_drawn("[[solids.rules]]\nmatch = \"gage-pad-1\"\ncutting = false\n"
                                 "rubs = true\n")),
                {.solids = "stl"});
  EXPECT_EQ(read((folder / "solids.toml").string()).parts[2].cutting, Cutting::rubs);
}

TEST(SolidsFile, lays_later_rules_over_earlier_ones) {
  const Bit b = read(write_drawn(R"([[solids.rules]]
match = "*"
density = "7.8 g/cm3"
update_direction = [0, 0, 1]
[[solids.rules]]
match = "cutter-?/face"
density = "3.5 g/cm3"
name = "tool"
kind = "tooth"
cutter_position = [0, 0, 0]
cutter_rotation_vector = [0, "-120 deg", 0]
)"));
  EXPECT_DOUBLE_EQ(b.parts[0].density, 3500.0);
  EXPECT_DOUBLE_EQ(b.parts[1].density, 7800.0);
  EXPECT_EQ(b.parts[0].name, "tool");
  EXPECT_EQ(b.parts[0].kind, PartKind::tooth);
  EXPECT_EQ(b.parts[0].update_direction_B, Vec3(0, 0, 1));
}

TEST(SolidsFile, takes_a_direction_from_a_cutters_frame) {
  const Bit b = read(
      write_drawn("[[solids.rules]]\nmatch = \"cutter-1/*\"\ncutter_position = [\"40 mm\", 0, 0]\n"
                  "cutter_rotation_vector = [0, \"-120 deg\", 0]\n"));
  EXPECT_NEAR((b.parts[0].update_direction_B - Vec3(std::sin(120 * M_PI / 180), 0, 0.5)).norm(), 0,
              1e-12);
  EXPECT_DOUBLE_EQ(b.parts[0].mesh_P.positions[0].z(), 1e-3);
}

TEST(SolidsFile, names_every_mistake_at_its_line) {
  auto solids = drawn();
  solids[0].name = "face no 1";
  solids[1].name = "gage-pad-1";
  expect_words(
      complaint(write_drawn("[[solids.rules]]\nmatch = \"bitbody\"\nkind = \"bodi\"\n", solids)),
      {"bit.toml:3: solids.file: found a solid \"face no 1\" whose name does not say its kind",
       "bit.toml:5: solids.rules[0].match: found \"bitbody\", no solid's", "did you mean bit-body?",
       "bit.toml:6: solids.rules[0].kind: found \"bodi\""});
}

TEST(SolidsFile, rejects_a_second_solid_of_a_name) {
  auto solids = drawn();
  solids[1].name = "cutter-1/face";
  expect_words(complaint(write_drawn("", solids)),
               {"bit.toml:3: solids.file: found a second solid \"cutter-1/face\""});
}

TEST(SolidsFile, names_the_command_that_repairs) {
  auto solids = drawn();
  solids[2].mesh.triangles.pop_back();
  const std::string message = complaint(write_drawn("", solids));
  expect_words(message, {"bit.toml:3: solids.file: found ", "which bounds no solid",
                         "bit.stl: solid gage-pad-1: hole: 3 times, first edge ",
                         "to repair: tdbd mesh ", "bit.stl --repair -o ", "bit-repaired.stl"});
}

TEST(SolidsFile, rejects_parts_beside_solids) {
  expect_words(complaint(write_drawn("[[parts]]\nname = \"a\"\n")),
               {"solids: found parts, a table or a design as well"});
}

TEST(SolidRules, names_give_the_kind) {
  EXPECT_EQ(kind_of_name("cone-2/row-3/tooth-14"), PartKind::tooth);
  EXPECT_EQ(kind_of_name("cone-2/body"), PartKind::cone);
  EXPECT_EQ(kind_of_name("leg-1"), PartKind::bit_body);
  EXPECT_EQ(kind_of_name("leg-1/insert-2"), PartKind::gage_pad);
  EXPECT_EQ(kind_of_name("cutter-2/land"), PartKind::chamfer);
  EXPECT_EQ(kind_of_name("blade"), std::nullopt);
}

}  // namespace tdbd::bit::solids_file_test

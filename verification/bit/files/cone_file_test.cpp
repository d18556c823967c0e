#include "bit/files/cone_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::cone_file_test {
namespace {

const std::string shell =
    "shell = [[\"10 mm\", \"10 mm\"], [\"40 mm\", \"30 mm\"], [\"50 mm\", \"36 mm\"], [\"60 mm\", "
    "\"34 mm\"], [\"64 mm\", \"25 mm\"]]\n";
const std::string cone = "[[cones]]\nazimuth = \"20 deg\"\n" + shell;
const std::string row = "[[cones.rows]]\ns = \"55 mm\"\nteeth = 6\n";

std::string file_of(const std::string& text) {
  return write_file(test_folder() / "bit.toml", "name = \"r\"\n" + text);
}

/// Each key of a cone, a row and a tooth ends where it belongs; no two have the same number.
TEST(ConeFile, takes_every_key_of_cone_and_tooth) {
  const Bit bit = read(file_of(
      "[journal]\nangle = \"36 deg\"\noffset = \"4 mm\"\nskew = \"1.5 deg\"\napex = \"3 mm\"\n"
      "foot_height = \"5 mm\"\n[mesh]\nsegments = 40\nfacets = 12\n[teeth]\nkind = "
      "\"chisel\"\ndiameter = \"11 mm\"\nwidth = \"7 mm\"\nprotrusion = \"6 mm\"\ncrest_length = "
      "\"5 mm\"\ncrest_width = \"2.5 mm\"\ntip_radius = \"3.5 mm\"\nembedding = \"4.5 "
      "mm\"\nhalf_angle = \"30 deg\"\ndensity = 14000\n" +
      cone +
      "density = 7700\nbody_cuts = true\n[[cones.rows]]\ns = \"54 mm\"\nsink = \"0.2 mm\"\nlean "
      "= \"3 deg\"\ngage = true\nangles = [0.5, 1.5, 3.5]\n"));
  const ConeLayout& c = bit.cones.at(0).layout;
  EXPECT_DOUBLE_EQ(c.journal_angle, 36 * degree);
  EXPECT_DOUBLE_EQ(c.offset, 4e-3);
  EXPECT_DOUBLE_EQ(c.skew, 1.5 * degree);
  EXPECT_DOUBLE_EQ(c.apex, 3e-3);
  EXPECT_DOUBLE_EQ(c.azimuth, 20 * degree);
  EXPECT_EQ(c.segments, 40);
  EXPECT_EQ(c.facets, 12);
  EXPECT_EQ(c.density, 7700.0);
  EXPECT_EQ(c.body, Cutting::cuts);
  ASSERT_EQ(c.shell.size(), 5U);
  EXPECT_DOUBLE_EQ(c.shell[1].s, 0.04);
  EXPECT_DOUBLE_EQ(c.shell[1].r, 0.03);
  const ToothRow& r = c.rows.at(0);
  EXPECT_DOUBLE_EQ(r.s, 0.054);
  EXPECT_DOUBLE_EQ(r.sink, 0.2e-3);
  EXPECT_DOUBLE_EQ(r.lean, 3 * degree);
  EXPECT_EQ(r.place, RowPlace::gage);
  EXPECT_EQ(r.angles, (std::vector<double>{0.5, 1.5, 3.5}));
  const ToothShape& t = r.shape;
  EXPECT_EQ(t.kind, ToothKind::chisel);
  EXPECT_DOUBLE_EQ(t.diameter, 11e-3);
  EXPECT_DOUBLE_EQ(t.width, 7e-3);
  EXPECT_DOUBLE_EQ(t.protrusion, 6e-3);
  EXPECT_DOUBLE_EQ(t.crest_length, 5e-3);
  EXPECT_DOUBLE_EQ(t.crest_width, 2.5e-3);
  EXPECT_DOUBLE_EQ(t.tip_radius, 3.5e-3);
  EXPECT_DOUBLE_EQ(t.embedding, 4.5e-3);
  EXPECT_DOUBLE_EQ(t.half_angle, 30 * degree);
  EXPECT_EQ(t.density, 14000.0);
}

/// Keys of a cone or row take precedence over those of [journal] and [teeth], for that cone or row
/// only.
TEST(ConeFile, lets_a_cone_and_a_row_differ_from_the_rest) {
  const Bit bit = read(file_of(
      "interference = \"report\"\n[journal]\nangle = \"36 deg\"\noffset = \"4 mm\"\n" + cone +
      "journal_angle = \"30 deg\"\noffset = \"2 mm\"\n[[cones.rows]]\ns = \"55 mm\"\nteeth = "
      "6\ndiameter = \"9 mm\"\n[[cones.rows]]\ns = \"30 mm\"\nteeth = 4\nspacing = [1, 2]\n"
      "first_angle = \"10 deg\"\n[[cones]]\nazimuth = \"170 deg\"\n" +
      shell + row));
  ASSERT_EQ(bit.cones.size(), 2U);
  const ConeLayout &a = bit.cones[0].layout, &b = bit.cones[1].layout;
  EXPECT_DOUBLE_EQ(a.journal_angle, 30 * degree);
  EXPECT_DOUBLE_EQ(b.journal_angle, 36 * degree);
  EXPECT_DOUBLE_EQ(a.offset, 2e-3);
  EXPECT_DOUBLE_EQ(b.offset, 4e-3);
  EXPECT_DOUBLE_EQ(b.azimuth, 170 * degree);
  EXPECT_DOUBLE_EQ(a.rows[0].shape.diameter, 9e-3);
  EXPECT_DOUBLE_EQ(a.rows[1].shape.diameter, ToothShape{}.diameter);
  EXPECT_EQ(a.rows[0].place, RowPlace::inner);
  EXPECT_EQ(a.rows[0].angles, spaced_angles(6, 0.0, {}));
  EXPECT_EQ(a.rows[1].angles, spaced_angles(4, 10 * degree, {1, 2}));
  EXPECT_EQ(a.body, Cutting::never);
}

TEST(ConeFile, takes_shank_and_gage) {
  const std::string shank =
      "[shank]\nradius = \"50 mm\"\nlength = \"120 mm\"\nheight = \"110 mm\"\ndensity = 7900\n";
  const std::string gage_row = "[[cones.rows]]\ns = \"55 mm\"\nteeth = 8\ngage = true\n";
  const Bit bit = read(file_of("gage_diameter = \"170 mm\"\n[journal]\nangle = \"36 deg\"\n" +
                               shank + cone + gage_row));
  EXPECT_NEAR(bit.gage_radius, 0.085, 1e-12);
  EXPECT_DOUBLE_EQ(bit.shank.radius, 0.05);
  EXPECT_DOUBLE_EQ(bit.shank.length, 0.12);
  EXPECT_DOUBLE_EQ(bit.shank.height, 0.11);
  EXPECT_DOUBLE_EQ(bit.shank.density, 7900.0);
  EXPECT_EQ(bit.parts.back().name, "bit-body");
}

const std::string with_shank =
    "gage_diameter = \"170 mm\"\n[journal]\nangle = \"36 deg\"\n[shank]\nradius = \"50 "
    "mm\"\nlength "
    "= \"120 mm\"\nheight = \"90 mm\"\n";
const std::string gage_rows = "[[cones.rows]]\ns = \"55 mm\"\nteeth = 8\ngage = true\n";

/// Each key of the legs has its own number; heights and the shirttail's radius follow shank and shell.
TEST(ConeFile, takes_every_key_of_legs) {
  const Legs all =
      read(file_of(with_shank +
                   "[legs]\nwidth = \"40 mm\"\nunder_gage = \"2 mm\"\nclearance = \"3 "
                   "mm\"\ntip_radius = \"24 mm\"\nshoulder = \"100 mm\"\ntop = \"130 "
                   "mm\"\ndensity = 7700\nrubs = false\ninserts = 2\ninsert_diameter = \"8 "
                   "mm\"\ninsert_length = \"7 mm\"\ninsert_protrusion = \"0.3 mm\"\n" +
                   cone + gage_rows))
          .legs;
  EXPECT_DOUBLE_EQ(all.width, 0.04);
  EXPECT_DOUBLE_EQ(all.under_gage, 2e-3);
  EXPECT_DOUBLE_EQ(all.clearance, 3e-3);
  EXPECT_DOUBLE_EQ(all.tip_radius, 24e-3);
  EXPECT_DOUBLE_EQ(all.shoulder, 0.1);
  EXPECT_DOUBLE_EQ(all.top, 0.13);
  EXPECT_EQ(all.density, 7700.0);
  EXPECT_EQ(all.cutting, Cutting::never);
  EXPECT_EQ(all.inserts, 2);
  EXPECT_DOUBLE_EQ(all.insert_diameter, 8e-3);
  EXPECT_DOUBLE_EQ(all.insert_length, 7e-3);
  EXPECT_DOUBLE_EQ(all.insert_protrusion, 0.3e-3);
  const Legs usual =
      read(file_of(with_shank + "[legs]\nwidth = \"40 mm\"\n" + cone + gage_rows)).legs;
  EXPECT_DOUBLE_EQ(usual.shoulder, 0.09);
  EXPECT_DOUBLE_EQ(usual.top, 0.15);
  EXPECT_EQ(usual.tip_radius, 0.0);
  EXPECT_EQ(usual.cutting, Cutting::rubs);
  EXPECT_EQ(usual.inserts, 0);
}

TEST(ConeFile, names_impossible_legs_at_their_line) {
  const auto of_legs = [](const std::string& legs) {
    return complaint(file_of(with_shank + "[legs]\n" + legs + cone + gage_rows));
  };
  EXPECT_EQ(of_legs("width = \"40 mm\"\n"), "");
  expect_words(of_legs("clearance = \"1 mm\"\n"), {"bit.toml:9: legs.width: "});
  expect_words(of_legs("width = \"40 mm\"\nunder_gage = \"-1 mm\"\n"),
               {"bit.toml:11: legs.under_gage: found \"-1 mm\", expected length in m, in [0, 10]"});
  expect_words(of_legs("width = \"40 mm\"\nclearance = \"0 mm\"\n"),
               {"bit.toml:11: legs.clearance: found \"0 mm\", expected length in m, in (0, 10]"});
  expect_words(
      of_legs("width = \"40 mm\"\ntop = \"80 mm\"\n"),
      {"bit.toml:11: legs.top: found 80 mm, expected a height above the shank's lower end, "
       "90 mm, and at most its upper one, 210 mm"});
  expect_words(of_legs("width = \"56 mm\"\n"),
               {"bit.toml:10: legs.width: found 56 mm, expected at most twice the shirttail's "
                "radius, 25 mm"});
  expect_words(of_legs("width = \"40 mm\"\ninserts = 9\n"),
               {"bit.toml:11: legs.inserts: found 9 of 9.5 mm, expected at most "});
  expect_words(
      complaint(file_of("[journal]\nangle = \"36 deg\"\n[legs]\nwidth = \"40 mm\"\n" + cone + row)),
      {"bit.toml:5: legs.width: found 40 mm, legs without a shank, expected [shank] with a "
       "radius"});
  std::string low = with_shank;
  low.replace(low.find("90 mm"), 5, "60 mm");
  expect_words(complaint(file_of(low + "[legs]\nwidth = \"40 mm\"\n" + cone + gage_rows)),
               {"bit.toml:8: shank.height: found 60 mm, where the inner side of leg-1 is ",
                "meets the leg"});
  expect_words(complaint(file_of(with_shank + "[legs]\nwidth = \"40 mm\"\n" + cone +
                                 "journal_angle = \"80 deg\"\n" + row)),
               {"cones[0].journal_angle: found 80 deg, expected at most 78 deg with legs"});
}

/// A tooth that stands out of the cone's base meets the leg, unless that is only to be reported.
TEST(ConeFile, rejects_a_leg_that_meets_a_cone) {
  const std::string meets =
      with_shank + "[legs]\nwidth = \"40 mm\"\n" + cone + gage_rows +
      "[[cones.rows]]\ns = \"62 mm\"\nteeth = 4\nfirst_angle = \"22.5 deg\"\ndiameter = \"6 mm\"\n"
      "protrusion = \"6 mm\"\n";
  const Bit bit = read(file_of("interference = \"report\"\n" + meets));
  const LegClearance clash = leg_clearances(bit).front();
  EXPECT_LT(clash.distance, 0.0);
  EXPECT_EQ(clash.part, "cone-1/row-2/tooth-1");
  expect_words(complaint(file_of(meets)),
               {"legs.clearance: found " + clearance_text(clash) + ", expected a gap"});
}

/// What it writes is read as the same bit, whatever it is.
TEST(ConeFile, is_written_as_it_was_read) {
  const Bit before = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const std::string text = cone_bit_text(before);
  const Bit after = read(write_file(test_folder() / "again.toml", text));
  ASSERT_EQ(after.cones.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const ConeLayout &a = after.cones[k].layout, &b = before.cones[k].layout;
    EXPECT_EQ(a.azimuth, b.azimuth);
    EXPECT_EQ(a.journal_angle, b.journal_angle);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.skew, b.skew);
    EXPECT_EQ(a.apex, b.apex);
    EXPECT_NEAR(a.foot_height, b.foot_height, 1e-12);  // settled on the bottom once more
    EXPECT_EQ(a.body, b.body);
    EXPECT_EQ(a.density, b.density);
    ASSERT_EQ(a.shell.size(), b.shell.size());
    for (std::size_t i = 0; i < b.shell.size(); ++i) {
      EXPECT_EQ(a.shell[i].s, b.shell[i].s);
      EXPECT_EQ(a.shell[i].r, b.shell[i].r);
    }
    ASSERT_EQ(a.rows.size(), b.rows.size());
    for (std::size_t j = 0; j < b.rows.size(); ++j) {
      EXPECT_EQ(a.rows[j].angles, b.rows[j].angles);
      EXPECT_EQ(a.rows[j].s, b.rows[j].s);
      EXPECT_EQ(a.rows[j].place, b.rows[j].place);
      EXPECT_EQ(a.rows[j].shape.kind, b.rows[j].shape.kind);
      for (const auto size :
           {&ToothShape::diameter, &ToothShape::width, &ToothShape::protrusion,
            &ToothShape::crest_length, &ToothShape::crest_width, &ToothShape::tip_radius,
            &ToothShape::half_angle, &ToothShape::embedding, &ToothShape::density})
        EXPECT_EQ(a.rows[j].shape.*size, b.rows[j].shape.*size);
    }
  }
  ASSERT_EQ(after.parts.size(), before.parts.size());
  EXPECT_EQ(after.parts.back().name, "leg-3/insert-7");
  for (std::size_t i = 0; i < before.parts.size(); ++i) {
    const Part &a = after.parts[i], &b = before.parts[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.cutting, b.cutting);
    EXPECT_EQ(a.density, b.density);
    EXPECT_NEAR(mesh::enclosed_volume(a.mesh_P) / mesh::enclosed_volume(b.mesh_P), 1.0, 1e-10);
  }
}

TEST(ConeFile, names_what_is_impossible_at_its_line) {
  const std::string head = "[journal]\nangle = \"36 deg\"\n";
  expect_words(complaint(file_of(head + "[mesh]\nfacets = 10\n" + cone + row)),
               {"bit.toml:5: mesh.facets: found 10, expected a multiple of 4"});
  for (const char* ratio : {"0", "-0.5"})
    expect_words(complaint(file_of(head + cone + row + "spacing = [1, " + ratio + "]\n")),
                 {"bit.toml:10: cones[0].rows[0].spacing: found " + std::string(ratio) +
                  ", expected ratios above 0"});
  expect_words(complaint(file_of(head + cone + row + "protrusion = \"-1 mm\"\n")),
               {"bit.toml:10: cones[0].rows[0].protrusion"});
  expect_words(complaint(file_of(head + cone + row + row)),
               {"bit.toml:11: cones[0].rows[1].s: found tooth 1 at 0 deg in tooth 1 of row 1, "
                "expected teeth that do not touch"});
  expect_words(
      complaint(file_of(
          head + "[[cones]]\nazimuth = \"0 deg\"\nshell = [[\"10 mm\", \"10 mm\"]]\n" + row)),
      {"bit.toml:6: cones[0].shell: found 1 points, expected at least two"});
  expect_words(complaint(file_of(head + cone)),
               {"bit.toml: r: found no tooth, expected at least one"});
  expect_words(
      complaint(file_of("gage_diameter = \"2 m\"\n" + head + cone + row + "gage = true\n")),
      {"cones[0].offset: found "});
}

/// Cones that overlap are named at the row or shell of the first, unless that is only to be reported.
TEST(ConeFile, rejects_cones_that_overlap) {
  const std::string two =
      "[journal]\nangle = \"36 deg\"\n" + cone + row +
      "[[cones.rows]]\ns = \"30 mm\"\nteeth = 4\n[[cones]]\nazimuth = \"80 deg\"\n" + shell + row;
  const Bit bit = read(file_of("interference = \"report\"\n" + two));
  const std::string why = complaint(file_of(two));
  std::set<std::string> keys;  // of several clashes at one key the worst is reported
  for (const Clearance& c : cone_clearances(bit.cones)) {
    if (!is_clash(c)) continue;
    const std::size_t at = c.part_a.find("/row-");
    const std::string key =
        at == std::string::npos ? "shell" : "rows[" + std::to_string(c.part_a[at + 5] - '1') + "]";
    if (!keys.insert(key).second) continue;
    EXPECT_NE(why.find("cones[0]." + key + ": found " + clearance_text(c) + ", expected a gap"),
              std::string::npos)
        << why;
  }
  EXPECT_GE(keys.size(), 2U);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(why, '\n')) + 1, keys.size()) << why;
}

TEST(ToothKinds, are_the_four_of_the_key) {
  EXPECT_EQ(tooth_kinds(), (std::vector<std::pair<std::string, ToothKind>>{
                               {"milled-chisel", ToothKind::milled_chisel},
                               {"hemispherical", ToothKind::hemispherical},
                               {"conical", ToothKind::conical},
                               {"chisel", ToothKind::chisel}}));
}

}  // namespace
}  // namespace tdbd::bit::cone_file_test

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bit/cutter/cutter.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/files/bit_parts.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/files/pdc_file.hpp"
#include "bit/generate.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "mesh/files/solids.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::bit::mesh_cutters_test {

/// The difference of two angles, rad, in (-pi, pi].
double apart(double a, double b) { return std::remainder(a - b, 2.0 * pi); }

/// A cutter whose tip is far enough from the axis to have an azimuth.
Cutter any_placed_cutter() {
  Cutter c = any_cutter();
  c.tip_radius += 1e-3;
  c.land_angle = number(60 * degree, 80 * degree);
  if (*rc::gen::element(false, true) && c.chamfer > 0.0) c.land = number(1e-4, 3e-4);
  if (*rc::gen::element(false, true)) c.wear = number(1e-4, 2e-3);
  c.X_BC = cutter_pose(c);
  return c;
}

/// Whatever the cutter's chamfers and wear, and wherever along its axis the frame is.
RC_GTEST_PROP(CutterFromMeshes, has_the_numbers_of_the_cutter_that_made_the_meshes, ()) {
  const Cutter c = any_placed_cutter();
  CutterMeshing meshing;
  meshing.rim_segments = 64;
  Pose X_BC = c.X_BC;
  X_BC.p += *rc::gen::element(0.0, 2e-3, -3e-3) * X_BC.R.col(0);
  const std::optional<Cutter> found = cutter_from_meshes(X_BC, cutter_parts(c, meshing));
  RC_ASSERT(found.has_value());
  constexpr double rounding = 1e-11;  // m and rad: of lengths below a metre over a millimetre
  EXPECT_NEAR(found->diameter, c.diameter, rounding);
  EXPECT_NEAR(found->tip_radius, c.tip_radius, rounding);
  EXPECT_NEAR(found->tip_height, c.tip_height, rounding);
  EXPECT_NEAR(apart(found->azimuth, c.azimuth), 0.0, rounding);
  EXPECT_NEAR(found->profile_angle, c.profile_angle, rounding);
  EXPECT_NEAR(found->back_rake, c.back_rake, rounding);
  EXPECT_NEAR(found->side_rake, c.side_rake, rounding);
  EXPECT_NEAR(found->chamfer, c.chamfer + c.land, rounding);
  EXPECT_NEAR(chamfer_depth(*found), chamfer_depth(c), rounding);
  EXPECT_LT((found->X_BC.p - c.X_BC.p).norm(), rounding);
}

/// A frame whose X lies in the face, one that looks backwards, and no face at all.
TEST(CutterFromMeshes, is_none_without_a_face_that_looks_forwards) {
  const Cutter c = table('b')[3];
  const std::vector<Part> parts = cutter_parts(c, {});
  const auto turned = [&](const Vec3& axis) {
    return Pose{c.X_BC.R * Eigen::AngleAxisd(0.5 * pi, axis).toRotationMatrix(), c.X_BC.p};
  };
  EXPECT_TRUE(cutter_from_meshes(c.X_BC, parts).has_value());
  EXPECT_FALSE(cutter_from_meshes(turned(Vec3(0.6, 0.0, 0.8)), parts).has_value());
  EXPECT_FALSE(cutter_from_meshes(c.X_BC, {parts.back()}).has_value());
  const Pose backwards{c.X_BC.R * Eigen::AngleAxisd(pi, Vec3::UnitZ()).toRotationMatrix(),
                       c.X_BC.p};
  EXPECT_FALSE(cutter_from_meshes(backwards, parts).has_value());
}

/// Written as solids and as parts, in every format: the same cutters in the same order.
TEST(MeshCutters, of_an_exported_bit_are_those_of_the_bit) {
  const auto folder = test_folder();
  const Bit original = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  for (const std::string format : {"stl", "ply"}) {
    std::filesystem::create_directories(folder / format);
    export_solids(folder / format, original, {.solids = format});
    export_bit(folder / format, original, {.parts = format});
    for (const std::string file : {"solids.toml", "bit.toml"}) {
      const Bit again = read((folder / format / file).string());
      ASSERT_EQ(again.cutters.size(), original.cutters.size()) << format << file;
      EXPECT_EQ(again.cutter_source, CutterSource::meshes);
      for (std::size_t i = 0; i < again.cutters.size(); ++i) {
        EXPECT_EQ(again.cutters[i].id, original.cutters[i].id);
        EXPECT_LT((tip_B(again.cutters[i]) - tip_B(original.cutters[i])).norm(), 3e-9);
      }
      for (std::size_t i = 0; i < again.parts.size(); ++i)
        EXPECT_EQ(again.parts[i].cutter, original.parts[i].cutter) << again.parts[i].name;
    }
  }
}

/// Back-up cutters, wear, zones and the body of a generated bit, in both exported files.
TEST(MeshCutters, of_an_exported_bit_keep_what_the_meshes_do_not_show) {
  const auto folder = test_folder();
  std::filesystem::create_directories(folder);
  const std::string design = TDBD_SOURCE_DIR "/cases/bits/generated.toml";
  const Bit original = read_bit(design, DirectionRule::hybrid, InsideRule::down,
                                Densities::as_given, {"design.wear.gage=0.5 mm"})
                           .bit;
  export_solids(folder, original, {.solids = "ply"});
  export_bit(folder, original, {.parts = "ply"});
  const auto has_wear = [](const Cutter& c) { return c.wear > 0.0; };
  const auto is_backup = [](const Cutter& c) { return c.under_exposure > 0.0; };
  EXPECT_GT(std::ranges::count_if(original.cutters, has_wear), 0);
  EXPECT_GT(std::ranges::count_if(original.cutters, is_backup), 0);
  for (const char* file : {"bit.toml", "solids.toml"}) {
    const Bit again = read((folder / file).string());
    ASSERT_EQ(again.cutters.size(), original.cutters.size()) << file;
    for (std::size_t i = 0; i < again.cutters.size(); ++i) {
      const Cutter &a = original.cutters[i], &b = again.cutters[i];
      EXPECT_EQ(std::tuple(b.blade, b.zone, b.under_exposure, b.wear),
                std::tuple(a.blade, a.zone, a.under_exposure, a.wear))
          << file << a.id;
    }
    ASSERT_TRUE(again.blades.has_value()) << file;
    EXPECT_EQ(again.blades->exposure, original.blades->exposure);
    EXPECT_EQ(again.blades->slot_depth, original.blades->slot_depth);
    EXPECT_EQ(again.blades->junk_slot_area, original.blades->junk_slot_area);
  }
}

/// The design values of a body need the body and cutters with which reports compare them.
TEST(MeshCutters, reject_a_body_that_reports_cannot_use) {
  const auto folder = test_folder();
  std::filesystem::create_directories(folder);
  Bit bare = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  std::erase_if(bare.parts, [](const Part& p) { return p.kind == PartKind::bit_body; });
  export_bit(folder, bare, {.parts = "ply"});
  try {
    read((folder / "bit.toml").string());
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(
        std::string(e.what()).find("body_design: found a bit without a part of kind bit-body, "
                                   "expected such a part, or no table [body_design]"),
        std::string::npos)
        << e.what();
  }
}

/// Solids lie in the bit's frame, and are written as parts in their cutters' frames.
TEST(MeshCutters, keep_their_frames_when_solids_are_written_as_parts) {
  const auto folder = test_folder();
  export_solids(folder, read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml"), {.solids = "ply"});
  const Bit solids = read((folder / "solids.toml").string());
  export_bit(folder, solids, {.parts = "ply"});
  write_cutter_table(folder, solids);
  const Bit again = read((folder / "bit.toml").string());
  EXPECT_EQ(again.cutters.size(), 28U);
  EXPECT_EQ(again.parts[0].update_direction_B, solids.parts[0].update_direction_B);
  EXPECT_LT((again.cutters[9].X_BC.p - solids.cutters[9].X_BC.p).norm(), 1e-12);
  EXPECT_FALSE(std::filesystem::exists(folder / "cutters.csv"));  // the meshes do not say the wear
}

/// A group with two faces has no single face, and a frame beside update_direction is any frame.
TEST(MeshCutters, need_one_face_and_a_frame_of_their_own) {
  const auto folder = test_folder();
  const Cutter c = table('b')[3];
  Bit one;
  one.name = "one";
  one.parts = cutter_parts(c, {});
  one.cutters = {c};
  for (Part& part : one.parts) part.cutter = 0;
  export_bit(folder, one, {.parts = "ply"});
  std::ifstream in(folder / "bit.toml");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  for (std::size_t at = 0; (at = text.find("group = -1", at)) != std::string::npos; ++at)
    text.replace(at, 10, "group = 4");
  const std::string as_chamfer = "kind = \"chamfer\"", with_two = [&] {
    std::string t = text;
    return t.replace(t.find(as_chamfer), as_chamfer.size(), "kind = \"face\"");
  }();
  const std::size_t cutters[] = {read(write_file(folder / "one.toml", text)).cutters.size(),
                                 read(write_file(folder / "two.toml", with_two)).cutters.size()};
  EXPECT_EQ(cutters[0], 1U);
  EXPECT_EQ(cutters[1], 0U);
  std::string directed = text;
  for (std::size_t at = 0; (at = directed.find("group = 4", at)) != std::string::npos; ++at)
    directed.insert(at, "update_direction = [0, 0, 1]\n"), at += 40;
  EXPECT_TRUE(read(write_file(folder / "directed.toml", directed)).cutters.empty());
}

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";

std::vector<Cutter> cutters_with(const std::vector<std::string>& overrides) {
  return read_bit(bit_b, DirectionRule::hybrid, InsideRule::down, Densities::as_given, overrides)
      .bit.cutters;
}

std::string mistake_of(const std::vector<std::string>& overrides) {
  try {
    cutters_with(overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// Changes of all cutters, of a blade and of one cutter add up, and the frames follow.
RC_GTEST_PROP(AdjustFile, changes_add_up, ()) {
  const auto angle = [](int n) { return std::to_string(n) + " deg"; };
  const int all = *battery::integer(0, 5), blade = *battery::integer(0, 5),
            one = *battery::integer(0, 5);
  const int turn = *battery::integer(-10, 10);
  const std::vector<Cutter> before = cutters_with({});
  const std::vector<Cutter> after = cutters_with(
      {"adjust.back_rake=" + angle(all), "adjust.blade.3.back_rake=" + angle(blade),
       "adjust.cutter.2.back_rake=" + angle(one), "adjust.blade.3.azimuth=" + angle(turn)});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const int more = all + (before[i].blade == 3 ? blade : 0) + (before[i].id == 2 ? one : 0);
    const double turned = before[i].blade == 3 ? turn * degree : 0.0;
    constexpr double rounding = 1e-14;
    RC_ASSERT(std::abs(after[i].back_rake - before[i].back_rake - more * degree) < rounding);
    RC_ASSERT(std::abs(after[i].azimuth - before[i].azimuth - turned) < 10.0 * rounding);
    RC_ASSERT(after[i].X_BC.R == cutter_pose(after[i]).R);
    RC_ASSERT(after[i].X_BC.p == cutter_pose(after[i]).p);
  }
}

TEST(AdjustFile, changes_zones_and_ranges) {
  const std::vector<Cutter> before = cutters_with({}),
                            after = cutters_with({"adjust.zone.nose.back_rake=2 deg",
                                                  "adjust.cutter.22-25.side_rake=1 deg",
                                                  "adjust.blade.1-2.azimuth=3 deg",
                                                  "adjust.cutter.1,3.back_rake=1 deg"});
  constexpr double rounding = 1e-14;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Cutter &a = before[i], &b = after[i];
    const double back = (a.zone == "nose" ? 2.0 : 0.0) + (a.id == 1 || a.id == 3 ? 1.0 : 0.0);
    EXPECT_NEAR(b.back_rake - a.back_rake, back * degree, rounding) << a.id;
    EXPECT_NEAR(b.side_rake - a.side_rake, a.id >= 22 && a.id <= 25 ? degree : 0.0, rounding);
    EXPECT_NEAR(b.azimuth - a.azimuth, a.blade <= 2 ? 3.0 * degree : 0.0, 10.0 * rounding);
  }
}

/// Angles in degrees are written as they were given, although sums in radians are rounded.
TEST(AdjustFile, writes_round_numbers) {
  const std::string text =
      cutter_table_text("b", cutters_with({"adjust.cutter.1-7.side_rake=-17 deg",
                                           "adjust.side_rake=2 deg", "adjust.back_rake=1.3 deg"}));
  EXPECT_NE(text.find("\nb,1,1,cone,19,5.144,359.428,14.035,-15,13.3,-15,"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("99999"), std::string::npos) << text;
}

/// The way along the profile is at right angles to the profile's normal.
TEST(AdjustFile, moves_along_the_tangent) {
  const std::vector<Cutter> before = cutters_with({}),
                            after = cutters_with({"adjust.cutter.6.along=2 mm"});
  const auto moved = std::ranges::find(after, 6, &Cutter::id) - after.begin();
  const auto i = static_cast<std::size_t>(moved);
  const Vec3 way = tip_B(after[i]) - tip_B(before[i]);
  EXPECT_NEAR(way.norm(), 2e-3, 1e-16);
  EXPECT_NEAR(way.dot(profile_normal_B(before[i])), 0.0, 1e-17);
  EXPECT_GT(after[i].tip_radius, before[i].tip_radius);
}

TEST(AdjustFile, rejects_what_the_bit_does_not_have) {
  EXPECT_EQ(mistake_of({"adjust.blade.9.azimuth=1 deg"}),
            "bit.set: adjust.blade.9.azimuth: found no blade 9 in the bit, expected a blade or a "
            "range of these: 1-5");
  EXPECT_EQ(mistake_of({"adjust.zone.sholder.back_rake=1 deg"}),
            "bit.set: adjust.zone.sholder.back_rake: found no zone sholder in the bit, expected a "
            "zone of the cutters: cone, nose, shoulder, gage");
  EXPECT_NE(
      mistake_of({"adjust.cutter.39-22.back_rake=1 deg"}).find("found no cutter 39-22 in the bit"),
      std::string::npos);
  EXPECT_EQ(mistake_of({"adjust.cutter.first.back_rake=1 deg"}),
            "bit.set: adjust.cutter.first.back_rake: found no cutter first in the bit, expected a "
            "cutter or a range of these: 1-28");
  EXPECT_EQ(mistake_of({"adjust.bak_rake=1 deg"}),
            "bit.set: adjust.bak_rake: found an unknown key, expected back_rake");
  EXPECT_NE(mistake_of({"adjust.back_rake=60 deg"}).find("expected an angle in -5..60"),
            std::string::npos);
  EXPECT_NE(mistake_of({"adjust.side_rake=50 deg"}).find("expected an angle in -45..45"),
            std::string::npos);
  EXPECT_NE(mistake_of({"adjust.cutter.1.along=-20 mm"}).find("expected a radius >= 0"),
            std::string::npos);
}

/// The largest change of the value is named, not [adjust]; a number without a unit is in rad.
TEST(AdjustFile, names_the_change_and_the_unit_of_an_impossible_rake) {
  EXPECT_EQ(mistake_of({"adjust.zone.shoulder.back_rake=5"}),
            "bit.set: adjust.zone.shoulder.back_rake: found 301.4 deg at cutter 12 after this "
            "change, expected an angle in -5..60 deg (a number without a unit is in rad; write it "
            "as '5 deg')");
  EXPECT_EQ(mistake_of({"adjust.back_rake=1 deg", "adjust.cutter.3.back_rake=80 deg"}),
            "bit.set: adjust.cutter.3.back_rake: found 93 deg at cutter 3 after this change, "
            "expected an angle in -5..60 deg");
}

/// The sizes at the ends of the range are still usual.
TEST(UnitQuestion, is_none_of_a_usual_size) {
  for (const double size : {0.02, 0.2, 1.2}) EXPECT_EQ(unit_question(size, 1.0, bit_across), "");
  EXPECT_NE(unit_question(0.0199, 1.0, bit_across), "");
  EXPECT_NE(unit_question(1.201, 1.0, bit_across), "");
}

/// Each unit in which the size would be usual, with that size.
TEST(UnitQuestion, lists_every_unit_that_fits) {
  EXPECT_EQ(unit_question(215.9, 1.0, bit_across),
            "a size of 215900 mm, where a bit has 20 to 1200 mm: is it in mm (unit = \"1 mm\": "
            "215.9 mm)?");
  EXPECT_EQ(unit_question(8.5e-3, 1e-3, bit_across),
            "a size of 8.5 mm, where a bit has 20 to 1200 mm: is it in cm (unit = \"1 cm\": 85 "
            "mm), in in (unit = \"1 in\": 215.9 mm)?");
  EXPECT_EQ(unit_question(0.2e-3, 1e-3, bit_across),
            "a size of 0.2 mm, where a bit has 20 to 1200 mm: is it in m (unit = \"1 m\": 200 "
            "mm)?");
  EXPECT_EQ(unit_question(1e9, 1.0, bit_across),
            "a size of 1e+12 mm, where a bit has 20 to 1200 mm: in what unit is it?");
}

/// In a unit of 25.4 mm, ends that the other unit just reaches count.
TEST(UnitQuestion, takes_a_unit_up_to_the_ends_of_the_range) {
  const SizeRange thing{"a thing", 0.25, 2.0};
  EXPECT_NE(unit_question(0.25e-3, 1e-3, thing).find("in m (unit = \"1 m\": 250 mm)"),
            std::string::npos);
  EXPECT_NE(unit_question(2e-3, 1e-3, thing).find("in m (unit = \"1 m\": 2000 mm)"),
            std::string::npos);
  EXPECT_EQ(unit_question(2.1e-3, 1e-3, thing),
            "a size of 2.1 mm, where a thing has 250 to 2000 mm: in what unit is it?");
}

}  // namespace tdbd::bit::mesh_cutters_test

#include "bit/files/mesh_cutters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/cutter/cutter_parts.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/generate.hpp"
#include "mesh/files/solids.hpp"

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
    export_solids(folder / format, original, format);
    export_bit(folder / format, original, format);
    for (const std::string file : {"solids.toml", "bit.toml"}) {
      const Bit again = read((folder / format / file).string());
      ASSERT_EQ(again.cutters.size(), original.cutters.size()) << format << file;
      EXPECT_EQ(again.cutters_from, CuttersFrom::meshes);
      for (std::size_t i = 0; i < again.cutters.size(); ++i) {
        EXPECT_EQ(again.cutters[i].id, original.cutters[i].id);
        EXPECT_LT((tip_B(again.cutters[i]) - tip_B(original.cutters[i])).norm(), 3e-9);
      }
      for (std::size_t i = 0; i < again.parts.size(); ++i)
        EXPECT_EQ(again.parts[i].cutter, original.parts[i].cutter) << again.parts[i].name;
    }
  }
}

/// Solids lie in the bit's frame, and are written as parts in their cutters' frames.
TEST(MeshCutters, keep_their_frames_when_solids_are_written_as_parts) {
  const auto folder = test_folder();
  export_solids(folder, read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml"), "ply");
  const Bit solids = read((folder / "solids.toml").string());
  export_bit(folder, solids, "ply");
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
  export_bit(folder, one, "ply");
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

}  // namespace tdbd::bit::mesh_cutters_test

#include "bit/cone/cone_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bit/cone_generate.hpp"

namespace tdbd::bit::cone_faults_test {

ConeLayout sound_cone() {
  ConeLayout c;
  c.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.045}};
  ToothRow inner, outer;
  inner.s = 0.04;
  inner.angles = spaced_angles(8, 0.0, {});
  outer.s = 0.08;
  outer.angles = spaced_angles(12, 0.0, {});
  c.rows = {inner, outer};
  return c;
}

void expect_fault(const ConeLayout& c, int row, const std::string& key, const std::string& found) {
  const std::vector<ConeFault> faults = cone_faults(c);
  ASSERT_FALSE(faults.empty()) << key;
  EXPECT_EQ(faults[0].row, row);
  EXPECT_EQ(faults[0].key, key);
  EXPECT_NE(faults[0].found.find(found), std::string::npos) << faults[0].found;
}

TEST(ConeFaults, are_none_for_a_sound_cone) { EXPECT_TRUE(cone_faults(sound_cone()).empty()); }

TEST(ConeFaults, tell_a_profile_that_folds) {
  ConeLayout c = sound_cone();
  c.shell[2].s = 0.03;
  expect_fault(c, -1, "shell",
               "a fold: point 3 at (s, r) = (30, 50) mm after (s, r) = (40, 30) mm");
  c.shell = {{0.01, 0.01}};
  expect_fault(c, -1, "shell", "1 points");
  c.shell = {{0.01, 0.01}, {0.02, 0.0}, {0.03, 0.01}};
  expect_fault(c, -1, "shell", "point 2");
  c.shell = {{0.01, -0.01}, {0.02, 0.01}};
  expect_fault(c, -1, "shell", "point 1");
}

TEST(ConeFaults, tell_a_row_off_the_shell) {
  ConeLayout c = sound_cone();
  c.rows[1].s = 0.0901;
  expect_fault(c, 1, "s", "90.1 mm");
}

TEST(ConeFaults, tell_angles_that_do_not_rise) {
  ConeLayout c = sound_cone();
  c.rows[0].angles = {0.1, 0.1};
  expect_fault(c, 0, "angles", "0.1 rad for tooth 2");
  c.rows[0].angles = {7.0};
  expect_fault(c, 0, "angles", "7 rad for tooth 1");
  c.rows[0].angles.clear();
  expect_fault(c, 0, "angles", "no tooth");
}

TEST(ConeFaults, tell_a_negative_size) {
  ConeLayout c = sound_cone();
  c.rows[1].shape.diameter = -0.01;
  expect_fault(c, 1, "diameter", "-10 mm");
}

/// Each kind of tooth asks for its own sizes, and for no other's.
TEST(ConeFaults, ask_each_kind_of_tooth_for_its_sizes) {
  using Key = std::pair<const char*, double ToothShape::*>;
  const Key width{"width", &ToothShape::width}, tip{"tip_radius", &ToothShape::tip_radius},
      crest_length{"crest_length", &ToothShape::crest_length},
      crest_width{"crest_width", &ToothShape::crest_width};
  const std::vector<std::pair<ToothKind, std::vector<Key>>> asked{
      {ToothKind::milled_chisel, {width, crest_length, crest_width}},
      {ToothKind::chisel, {crest_length, crest_width}},
      {ToothKind::conical, {tip}},
      {ToothKind::hemispherical, {}}};
  for (const auto& [kind, own] : asked)
    for (const Key& key : {width, tip, crest_length, crest_width}) {
      ConeLayout c = sound_cone();
      c.rows[1].shape.kind = kind;
      ASSERT_TRUE(cone_faults(c).empty());
      c.rows[1].shape.*key.second = 0.0;
      const bool wanted =
          std::ranges::any_of(own, [&](const Key& k) { return k.second == key.second; });
      if (wanted)
        expect_fault(c, 1, key.first, "0 mm");
      else
        EXPECT_EQ(cone_faults(c).size(), 0U) << key.first;
    }
}

TEST(ConeFaults, tell_a_tooth_inside_the_cone) {
  ConeLayout c = sound_cone();
  c.rows[0].sink = 0.008;
  expect_fault(c, 0, "protrusion", "mm inside the cone");
}

TEST(ConeFaults, tell_a_base_off_the_cone) {
  ConeLayout c = sound_cone();
  c.rows[1].sink = -0.01;
  expect_fault(c, 1, "embedding", "a base that stands");
}

TEST(ConeFaults, tell_rows_that_collide) {
  ConeLayout c = sound_cone();
  c.rows[1].s = 0.045;
  expect_fault(c, 1, "s", "tooth 1 at 0 deg in tooth 1 of row 1");
  c = sound_cone();
  c.rows[0].angles = spaced_angles(40, 0.0, {});
  expect_fault(c, 0, "s", "tooth 2 at 9 deg in tooth 1 of row 1");
}

/// Rows at one place whose teeth stand in each other's gaps do not collide.
TEST(ConeFaults, allow_rows_that_interlock) {
  ConeLayout c = sound_cone();
  c.rows[0].angles = spaced_angles(4, 0.0, {});
  c.rows[1] = c.rows[0];
  c.rows[1].s += 0.002;
  c.rows[1].angles = spaced_angles(4, pi / 4, {});
  EXPECT_TRUE(cone_faults(c).empty());
}

}  // namespace tdbd::bit::cone_faults_test

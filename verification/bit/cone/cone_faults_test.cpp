#include "bit/cone/cone_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

/// Of more planes than a part's solid may have (mesh::most_planes), too.
TEST(ConeFaults, are_none_for_teeth_of_many_facets) {
  ConeLayout c = sound_cone();
  c.facets = 64;
  EXPECT_TRUE(cone_faults(c).empty());
  c.rows[0].angles = {0.0, 0.05};
  expect_fault(c, 0, "s", "tooth 2 at 2.865 deg in tooth 1 of row 1");
}

TEST(ConeFaults, report_a_profile_that_folds) {
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

TEST(ConeFaults, report_a_row_off_the_shell) {
  ConeLayout c = sound_cone();
  c.rows[1].s = 0.0901;
  expect_fault(c, 1, "s", "90.1 mm");
}

TEST(ConeFaults, report_angles_that_do_not_increase) {
  ConeLayout c = sound_cone();
  c.rows[0].angles = {0.1, 0.1};
  expect_fault(c, 0, "angles", "0.1 rad for tooth 2");
  c.rows[0].angles = {7.0};
  expect_fault(c, 0, "angles", "7 rad for tooth 1");
  c.rows[0].angles.clear();
  expect_fault(c, 0, "angles", "no tooth");
}

TEST(ConeFaults, report_a_negative_size) {
  ConeLayout c = sound_cone();
  c.rows[1].shape.diameter = -0.01;
  expect_fault(c, 1, "diameter", "-10 mm");
}

/// Each kind of tooth requires its own sizes and no others.
TEST(ConeFaults, require_the_sizes_of_each_kind_of_tooth) {
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

ToothShape tooth_of(ToothKind kind) {
  ToothShape t;
  t.kind = kind;
  t.diameter = 0.5;  // lengths whose sums are exact
  t.protrusion = 0.25;
  t.embedding = 0.25;
  return t;
}

/// The rejected keys; the message for the first one contains the expected value.
std::string refused(const ToothShape& t) {
  std::string keys;
  for (const ConeFault& fault : tooth_faults(t))
    keys += (keys.empty() ? "" : ", ") + fault.key + ": " + fault.found + ", " + fault.expected;
  return keys;
}

/// A half-ball must end above the insert's lower end: what ends right there has no shank.
TEST(ToothFaults, leave_a_half_ball_some_shank) {
  ToothShape t = tooth_of(ToothKind::hemispherical);
  t.protrusion = 0.125;
  t.embedding = 0.1251;
  EXPECT_EQ(refused(t), "");
  t.embedding = 0.125;
  EXPECT_EQ(refused(t),
            "embedding: 125 mm, more than the half-ball reaches below the shell, 125 mm");
}

/// A tooth with a missing size produces no other message, because the others would follow from it.
TEST(ToothFaults, report_missing_sizes_alone) {
  for (const ToothKind kind : all_tooth_kinds) {
    ToothShape t = tooth_of(kind);
    t.protrusion = -0.25;
    EXPECT_EQ(refused(t), "protrusion: -250 mm, a length above 0");
    t.embedding = 0.0;
    EXPECT_EQ(refused(t),
              "protrusion: -250 mm, a length above 0, embedding: 0 mm, a length above 0");
  }
}

/// A crest may be as long and as wide as what it stands on, and no more.
TEST(ToothFaults, keep_a_crest_on_its_tooth) {
  ToothShape t = tooth_of(ToothKind::chisel);
  t.crest_length = 0.5;
  t.crest_width = 0.5;
  t.width = 0.1;  // of milled teeth alone
  EXPECT_EQ(refused(t), "");
  t.crest_width = 0.51;
  EXPECT_EQ(refused(t), "crest_width: 510 mm, at most 500 mm");
  t.crest_width = 0.2;
  t.crest_length = 0.51;
  EXPECT_EQ(refused(t), "crest_length: 510 mm, at most 500 mm");
  t.kind = ToothKind::milled_chisel;
  t.crest_length = 0.4;
  EXPECT_EQ(refused(t), "crest_width: 200 mm, at most 100 mm");
  t.crest_width = 0.1;
  EXPECT_EQ(refused(t), "");
}

/// With a flank of 45 degrees its height is r (1 - sqrt(1/2)) + D/2 - r sqrt(1/2).
TEST(ToothFaults, keep_a_flank_above_the_lower_end) {
  ToothShape t = tooth_of(ToothKind::conical);
  t.half_angle = 45 * degree;
  t.tip_radius = 0.1;
  const double flank = 0.1 * (1.0 - std::sqrt(0.5)) + 0.25 - 0.1 * std::sqrt(0.5);
  for (const double more : {1e-9, -1e-9}) {
    t.protrusion = 0.1;
    t.embedding = flank - 0.1 + more;
    EXPECT_EQ(refused(t).empty(), more > 0.0) << refused(t);
  }
  EXPECT_EQ(refused(t),
            "half_angle: 0.7854 rad, a flank 208.579 mm high, a flank lower than protrusion and "
            "embedding together, 208.579 mm");
  t.embedding = 0.4;
  t.tip_radius = 0.25 / std::cos(t.half_angle) * (1.0 - 1e-9);
  EXPECT_EQ(refused(t), "");
  t.tip_radius *= 1.0 + 2e-9;
  EXPECT_EQ(refused(t), "tip_radius: 250 mm, at most 250 mm");
}

/// A shell may begin and end on the axis, with rows at its very ends.
TEST(ConeFaults, allow_ends_of_a_shell_on_the_axis) {
  ConeLayout c = sound_cone();
  c.rows.clear();
  c.shell.front().r = 0.0;
  c.shell.back().r = 0.0;
  EXPECT_TRUE(cone_faults(c).empty());
  c.shell[1].s = c.shell[0].s;
  expect_fault(c, -1, "shell", "a fold: point 2");
}

TEST(ConeFaults, allow_rows_at_the_ends_of_the_shell_and_no_farther) {
  ConeLayout c = sound_cone();
  c.rows.resize(1);
  for (const double s : {c.shell.front().s, c.shell.back().s}) {
    c.rows[0].s = s;
    for (const ConeFault& fault : cone_faults(c)) EXPECT_NE(fault.key, "s");
  }
  c.rows[0].s = 0.0099;
  expect_fault(c, 0, "s", "9.9 mm");
  EXPECT_EQ(cone_faults(c)[0].expected, "a place on the shell, from 10 to 90 mm");
}

/// The first angle may be 0, none may be a whole turn.
TEST(ConeFaults, allow_angles_from_0_to_below_a_turn) {
  ConeLayout c = sound_cone();
  c.rows[0].angles = {0.0, 5.5};
  EXPECT_TRUE(cone_faults(c).empty());
  c.rows[0].angles = {0.0, full_turn};
  expect_fault(c, 0, "angles", "6.28319 rad for tooth 2");
  c.rows[0].angles = {-1e-9, 1.0};
  expect_fault(c, 0, "angles", "-1e-09 rad for tooth 1");
  c.rows[0].angles = {1.0, 3.0, 2.0};
  expect_fault(c, 0, "angles", "2 rad for tooth 3");
}

/// All faults of all rows are reported, each with its row.
TEST(ConeFaults, are_reported_for_every_row) {
  ConeLayout c = sound_cone();
  c.rows[0].angles.clear();
  c.rows[1].shape.diameter = 0.0;
  c.rows[1].shape.protrusion = 0.0;
  const std::vector<ConeFault> faults = cone_faults(c);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].row, 0);
  EXPECT_EQ(faults[1].row, 1);
  EXPECT_EQ(faults[1].key, "diameter");
  EXPECT_EQ(faults[2].key, "protrusion");
}

TEST(ConeFaults, report_a_tooth_inside_the_cone) {
  ConeLayout c = sound_cone();
  c.rows[0].sink = 0.008;
  expect_fault(c, 0, "protrusion", "mm inside the cone");
}

TEST(ConeFaults, report_a_base_off_the_cone) {
  ConeLayout c = sound_cone();
  c.rows[1].sink = -0.01;
  expect_fault(c, 1, "embedding", "a base that stands");
}

TEST(ConeFaults, report_rows_that_collide) {
  ConeLayout c = sound_cone();
  c.rows[1].s = 0.045;
  expect_fault(c, 1, "s", "tooth 1 at 0 deg in tooth 1 of row 1");
  c = sound_cone();
  c.rows[0].angles = spaced_angles(40, 0.0, {});
  expect_fault(c, 0, "s", "tooth 2 at 9 deg in tooth 1 of row 1");
}

/// Rows at the same place whose teeth interlock do not collide.
TEST(ConeFaults, allow_rows_that_interlock) {
  ConeLayout c = sound_cone();
  c.rows[0].angles = spaced_angles(4, 0.0, {});
  c.rows[1] = c.rows[0];
  c.rows[1].s += 0.002;
  c.rows[1].angles = spaced_angles(4, pi / 4, {});
  EXPECT_TRUE(cone_faults(c).empty());
}

}  // namespace tdbd::bit::cone_faults_test

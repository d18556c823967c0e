#include "bit/pdc/gage_pads.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::gage_pads_test {

constexpr double gage = 0.1;

RC_GTEST_PROP(GagePads, stay_under_gage_and_reach_it, ()) {
  GagePads pads;
  pads.count = *rc::gen::inRange(1, 9);
  pads.width = number(0.01, 0.03);
  pads.under_gage = number(0, 1e-3);
  for (const Part& pad : gage_pads(pads, table('b'), gage)) {
    double reach = 0.0;
    for (const Vec3& x_P : pad.mesh_P.positions)
      reach = std::max(reach, (pad.X_BP * x_P).head<2>().norm());
    RC_ASSERT(std::abs(reach - (gage - pads.under_gage)) < 1e-15);
    RC_ASSERT(is_closed_and_oriented(pad.mesh_P));
  }
}

/// What is refused makes no pad: one whose outline crosses itself or the axis. What is not refused makes closed ones.
RC_GTEST_PROP(PadProblems, are_none_of_pads_that_are_solids, ()) {
  GagePads pads;
  pads.count = *rc::gen::inRange(1, 9);
  pads.width = number(0.001, 0.4);
  pads.thickness = number(0.0005, 0.12);
  pads.under_gage = number(0, 0.12);
  const double radius = gage - pads.under_gage;
  const bool across = radius <= 0.0 || pads.thickness >= radius;
  const std::vector<PadProblem> problems = pad_problems(pads, gage);
  RC_TAG(problems.empty() ? "possible" : "impossible");
  if (!problems.empty()) return;
  RC_ASSERT(!across);
  for (const Part& pad : gage_pads(pads, table('b'), gage)) {
    RC_ASSERT(is_closed_and_oriented(pad.mesh_P));
    RC_ASSERT(mesh::enclosed_volume(pad.mesh_P) > 0.0);
    RC_ASSERT(mesh::bounding_box(pad.mesh_P).lo.x() > 0.0);
  }
}

TEST(PadProblems, name_the_key_and_what_would_do) {
  const auto key_of = [](int count, double width, double under_gage, double thickness) {
    GagePads pads;
    pads.count = count;
    pads.width = width;
    pads.under_gage = under_gage;
    pads.thickness = thickness;
    const std::vector<PadProblem> problems = pad_problems(pads, gage);
    return problems.empty() ? "" : problems.front().key;
  };
  EXPECT_EQ(key_of(4, 0.03, 4e-4, 0.01), "");
  EXPECT_EQ(key_of(4, 0.03, 0.2, 0.01), "under_gage");
  EXPECT_EQ(key_of(4, 0.16, 4e-4, 0.03), "width");
  EXPECT_EQ(key_of(2, 0.2, 4e-4, 0.01), "thickness");
  EXPECT_EQ(key_of(4, 0.03, 4e-4, 0.0999), "thickness");
  EXPECT_EQ(key_of(0, 0.03, 0.2, 0.01), "");
}

/// Inscribed arc of 8 chords, less the flat back: the volume is closed-form.
TEST(GagePads, have_the_volume_of_their_prism) {
  GagePads pads;
  pads.count = 1;
  const Part pad = gage_pads(pads, table('b'), gage).front();
  const double radius = gage - pads.under_gage, half = 0.5 * pads.width / radius;
  const double fan = 0.5 * 8 * radius * radius * std::sin(half / 4);
  const double triangle = 0.5 * radius * radius * std::sin(2 * half);
  const double back =
      2 * radius * std::sin(half) * (radius * std::cos(half) - radius + pads.thickness);
  EXPECT_NEAR(mesh::enclosed_volume(pad.mesh_P), pads.length * (fan - triangle + back), 1e-18);
}

TEST(GagePads, start_above_the_highest_cutter_unless_told) {
  GagePads pads;
  pads.count = 2;
  const auto lower_end = [&] {
    return mesh::bounding_box(gage_pads(pads, table('b'), gage).front().mesh_P).hi.z();
  };
  EXPECT_NEAR(lower_end(), -(59.558e-3 + 9.5e-3), 1e-15);
  pads.height = 0.08;
  EXPECT_EQ(lower_end(), -0.08);
}

TEST(GagePads, cut_outwards_and_can_be_left_out) {
  GagePads pads;
  EXPECT_TRUE(gage_pads(pads, table('b'), gage).empty());
  pads.count = 6;
  const std::vector<Part> parts = gage_pads(pads, table('b'), gage);
  ASSERT_EQ(parts.size(), 6u);
  EXPECT_EQ(parts[5].name, "gage-pad-6");
  EXPECT_EQ(parts[5].cutting, Cutting::cuts);
  EXPECT_EQ(parts[5].update_direction_B, Vec3(1, 0, 0));
}

}  // namespace tdbd::bit::gage_pads_test

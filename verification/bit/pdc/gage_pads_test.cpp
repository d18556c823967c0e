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

#include "bit/pdc/pdc_bit.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "reference/bit/heel_drag.hpp"

namespace tdbd::bit::pdc_bit_test {

constexpr double gage = 107.95e-3;

TEST(PdcBit, reaches_its_gage_exactly) {
  for (const char letter : {'a', 'b', 'c'})
    EXPECT_NEAR(example_bit(letter).gage_radius, gage, 1e-15);
}

TEST(PdcBit, keeps_the_order_of_the_table) {
  const Bit bit = example_bit('b');
  ASSERT_EQ(bit.parts.size(), 3 * 28u + 1u);
  for (int i = 0; i < 28; ++i) {
    const std::string cutter = "cutter-" + std::to_string(i + 1);
    EXPECT_EQ(bit.parts[3 * i].name, cutter + "/face");
    EXPECT_EQ(bit.parts[3 * i + 1].name, cutter + "/chamfer");
    EXPECT_EQ(bit.parts[3 * i + 2].name, cutter + "/body");
    for (int k = 0; k < 3; ++k) EXPECT_EQ(bit.parts[3 * i + k].group, i);
  }
  EXPECT_EQ(bit.parts.back().name, "bit-body");
  EXPECT_EQ(bit.parts.back().cutting, Cutting::never);
}

TEST(PdcBit, has_closed_parts_with_outward_normals) {
  PdcOptions options;
  options.pads.count = 5;
  for (const char letter : {'a', 'b', 'c'})
    for (const Part& part : example_bit(letter, options).parts) {
      EXPECT_TRUE(is_closed_and_oriented(part.mesh_P)) << part.name;
      EXPECT_GT(mesh::enclosed_volume(part.mesh_P), 0.0) << part.name;
    }
}

/// No vertex of the body reaches the groove of any cutter near it: the body stays behind the tips.
TEST(PdcBit, sets_its_body_back_behind_the_cutters) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    for (const Vec3& x : bit.parts.back().mesh_P.positions)
      for (const Cutter& c : bit.cutters) {
        const Vec3 n = profile_normal_B(c);
        const double r = std::hypot(x.x(), x.y()) - c.tip_radius, z = x.z() + c.tip_height;
        if (std::hypot(r, z) > c.diameter) continue;
        const double height = std::sin(c.profile_angle) * r + n.z() * z;
        EXPECT_LT(height, -0.2 * c.diameter) << letter << c.id;
      }
  }
}

TEST(PdcBit, without_cutters_is_an_error) { EXPECT_THROW(pdc_bit("none", {}, {}), InputError); }

}  // namespace tdbd::bit::pdc_bit_test

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

TEST(GagePads, start_above_the_highest_cutter_by_default) {
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

namespace tdbd::bit::heel_drag_test {

using reference::heel_drag;

constexpr double advance = 2e-3;  // m per revolution

TEST(HeelDrag, every_cutter_of_the_example_bits_away_from_the_axis_is_relieved) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    const std::vector<double> drag = heel_drag(bit, advance);
    ASSERT_EQ(drag.size(), bit.cutters.size());
    for (std::size_t k = 0; k < drag.size(); ++k) {
      const bool near_axis = bit.cutters[k].tip_radius <= 0.01;
      EXPECT_TRUE(near_axis || drag[k] < 0.0) << letter << k + 1 << ": " << drag[k];
    }
  }
}

/// The mistake that shows only in a picture: with the other sign of back rake the heel drags.
TEST(HeelDrag, a_cutter_that_leans_the_other_way_drags_its_heel) {
  Bit bit = example_bit('b');
  for (Cutter& c : bit.cutters) {
    c.back_rake = -c.back_rake;
    c.X_BC = cutter_pose(c);
  }
  for (const double drag : heel_drag(bit, advance)) EXPECT_GT(drag, 1e-3);
}

/// Far from the axis the groove is straight and the heel's height is closed-form: after a length s
/// the body stands s sin b clear of the edge, less the advance along the helix.
TEST(HeelDrag, far_from_the_axis_is_that_of_a_plane) {
  Cutter c = table('b').at(8);
  c.tip_radius = 1e3;
  c.profile_angle = c.side_rake = 0.0;
  c.X_BC = cutter_pose(c);
  const double s = (c.length - chamfer_depth(c)) / 64.0;
  EXPECT_NEAR(heel_drag({"far", {}, {c}, 0.0, {}, {}, {}}, advance).front(),
              -s * std::sin(c.back_rake), 3e-10);
}

TEST(HeelDrag, is_used_up_by_a_fast_enough_advance) {
  const Bit bit = example_bit('a');
  EXPECT_GT(heel_drag(bit, 0.1)[2], heel_drag(bit, advance)[2] + 1e-4);
}

/// Cutter 9 of bit B with this wear, at radius r (m), its profile normal down or out.
Cutter worn_cutter(double r, double profile_angle, double wear) {
  Cutter c = table('b').at(8);
  c.tip_radius = r;
  c.profile_angle = profile_angle;
  c.side_rake = 0.0;
  c.wear = wear;
  c.X_BC = cutter_pose(c);
  return c;
}

double drag_of(const Cutter& c, double advance_per_rev) {
  return heel_drag({"worn", {}, {c}, 0.0, {}, {}, {}}, advance_per_rev).front();
}

/// Behind the tip the flat is as long as it takes the body to rise by the wear: e = wear / tan b.
/// The heel is sampled in 64 steps of the body's length.
TEST(HeelDrag, a_wear_flat_at_the_nose_drags_by_the_helix_over_its_length) {
  const double r = 0.09, step = 13e-3 / 64;
  const Cutter c = worn_cutter(r, 0.0, 1e-3);
  const double e = c.wear / std::tan(c.back_rake);
  EXPECT_NEAR(drag_of(c, 5e-3), 5e-3 * e / (2 * pi * r), 5e-3 * step / (2 * pi * r));
  EXPECT_LT(drag_of(worn_cutter(r, 0.0, 0.0), 5e-3), 0.0);
}

TEST(HeelDrag, a_wear_flat_at_the_gage_drags_by_the_bend_of_its_path) {
  const double r = 0.10795, step = 13e-3 / 64;
  const Cutter c = worn_cutter(r, pi / 2, 1e-3);
  const double e = c.wear / std::tan(c.back_rake);
  EXPECT_NEAR(drag_of(c, 5e-3), e * e / (2 * r), 1.9 * e * step / r);
}

/// A cutter that is not worn is measured as before; more wear never drags less.
RC_GTEST_PROP(HeelDrag, wear_never_relieves, ()) {
  const double angle = number(0.0, 90 * degree), wear = number(1e-4, 2e-3);
  const double fresh = drag_of(worn_cutter(0.1, angle, 0.0), advance);
  const double worn = drag_of(worn_cutter(0.1, angle, wear), advance);
  RC_ASSERT(worn > fresh);
  RC_ASSERT(drag_of(worn_cutter(0.1, angle, 1.5 * wear), advance) >= worn);
}

}  // namespace tdbd::bit::heel_drag_test

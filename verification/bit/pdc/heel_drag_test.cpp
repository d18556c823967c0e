#include "reference/bit/heel_drag.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"

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

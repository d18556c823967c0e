#include "bit/relief.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"

namespace tdbd::bit {
namespace {

constexpr double advance = 2e-3;  // m per revolution

TEST(relief, every_cutter_of_the_example_bits_away_from_the_axis_is_relieved) {
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
TEST(relief, a_cutter_that_leans_the_other_way_drags_its_heel) {
  Bit bit = example_bit('b');
  for (Cutter& c : bit.cutters) {
    c.back_rake = -c.back_rake;
    c.X_BC = cutter_pose(c);
  }
  for (const double drag : heel_drag(bit, advance)) EXPECT_GT(drag, 1e-3);
}

/// Far from the axis the groove is straight and the heel's height is closed-form: after a length s
/// the body stands s sin b clear of the edge, less the advance along the helix.
TEST(relief, far_from_the_axis_is_that_of_a_plane) {
  Cutter c = table('b').at(8);
  c.tip_radius = 1e3;
  c.profile_angle = c.side_rake = 0.0;
  c.X_BC = cutter_pose(c);
  const double s = (c.length - chamfer_depth(c)) / 16.0;
  EXPECT_NEAR(heel_drag({"far", {}, {c}, 0.0, {}, {}}, advance).front(), -s * std::sin(c.back_rake),
              1e-7);
}

TEST(relief, is_used_up_by_a_fast_enough_advance) {
  const Bit bit = example_bit('a');
  EXPECT_GT(heel_drag(bit, 0.1)[2], heel_drag(bit, advance)[2] + 1e-4);
}

}  // namespace
}  // namespace tdbd::bit

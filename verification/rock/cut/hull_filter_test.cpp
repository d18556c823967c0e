#include "rock/cut/hull_filter.hpp"

#include <gtest/gtest.h>

#include "rock/cut/cut_rock.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::hull_filter_test {

/// What touches a side is left to the exact tests, and what is beyond it is not.
TEST(HullFilter, keeps_outside_what_is_beyond_a_side_of_a_box_and_not_what_is_on_it) {
  const Vec3 lo(-0.25, -0.5, -0.125), hi(0.5, 0.25, 0.375);
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = battery::box(lo, hi);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const CuttingGroup& g = cutting.groups[0];
  ASSERT_EQ(g.radius, 0.0);
  const GroupMotion at_rest = group_motion(g, Pose{}, Pose{});
  for (int k = 0; k < 3; ++k)
    for (const bool upper : {false, true}) {
      Vec3 x = 0.5 * (lo + hi);
      x[k] = upper ? hi[k] : lo[k];
      EXPECT_FALSE(keeps_outside(g, at_rest, x)) << k << upper;
      x[k] += upper ? 1e-3 : -1e-3;
      EXPECT_TRUE(keeps_outside(g, at_rest, x)) << k << upper;
    }
}

}  // namespace tdbd::rock::hull_filter_test

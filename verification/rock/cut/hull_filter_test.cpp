#include "rock/cut/hull_filter.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/tolerance.hpp"
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

/// A prism of 8 sides about x: the cylinder through its corners stands out over its facets.
TEST(HullFilter, keeps_outside_what_is_beyond_the_cylinder_of_a_round_part) {
  constexpr double radius = 0.2;
  const Pose to_x{.R = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix(),
                  .p = Vec3::Zero()};
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = battery::placed(to_x, battery::cylinder(radius, 0.1, 8));
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const CuttingGroup& g = cutting.groups[0];
  ASSERT_NEAR(g.radius, radius, 1.1 * tolerance::convex * g.box_P.size().norm());
  const GroupMotion at_rest = group_motion(g, Pose{}, Pose{});
  for (int i = 0; i < 16; ++i) {
    const double a = 2.0 * std::numbers::pi * (i + 0.5) / 16.0;
    const Vec3 out(0.0, std::cos(a), std::sin(a));
    EXPECT_FALSE(keeps_outside(g, at_rest, 0.999 * radius * out)) << i;
    EXPECT_TRUE(keeps_outside(g, at_rest, 1.001 * radius * out)) << i;
    EXPECT_FALSE(is_far_from(g, 1.009 * radius * out, 0.01 * radius)) << i;
    EXPECT_TRUE(is_far_from(g, 1.011 * radius * out, 0.01 * radius)) << i;
  }
}

}  // namespace tdbd::rock::hull_filter_test

#include "bit/body/blade_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angles.hpp"

namespace tdbd::bit::blade_shape_test {

constexpr double rounding = 1e-15;  // m, of lengths below 0.1 m

/// Tips on a straight line that leaves the axis at a slope: the place of each is its radius over a cosine.
std::vector<Cutter> on_a_cone(double angle) {
  std::vector<Cutter> cutters;
  for (const double r : {0.02, 0.03, 0.045, 0.07}) {
    Cutter c;
    c.tip_radius = r;
    c.tip_height = std::tan(angle) * r;
    c.profile_angle = angle;
    c.blade = 1;
    cutters.push_back(c);
  }
  return cutters;
}

TEST(BladeShape, follows_the_tips_at_its_exposure_and_depth) {
  for (const double angle : {0.0, 0.3, 0.6}) {
    const auto cutters = on_a_cone(angle);
    const BladeOptions options{.exposure = 4e-3, .slot_depth = 9e-3, .gage_length = 0.03};
    const BladeShape shape = blade_shape(cutters, options);
    ASSERT_EQ(shape.meridian.size(), 6U);  // the axis, four cutters, the end of the gage
    EXPECT_EQ(shape.meridian.front().top.r, 0.0);
    const double s = std::sin(angle), c = std::cos(angle);
    for (std::size_t k = 0; k < cutters.size(); ++k) {
      const MeridianNode& at = shape.meridian[k + 1];
      const double r = cutters[k].tip_radius, z = -cutters[k].tip_height;
      EXPECT_NEAR(at.s, r / c, rounding);
      EXPECT_NEAR(at.top.r, r - options.exposure * s, rounding);
      EXPECT_NEAR(at.top.z, z - options.exposure * c, rounding);
      EXPECT_NEAR(at.floor.r, r - (options.exposure + options.slot_depth) * s, rounding);
      EXPECT_NEAR(at.floor.z, z - (options.exposure + options.slot_depth) * c, rounding);
      EXPECT_NEAR(place_of(shape, cutters[k]), at.s, rounding);
    }
    const MeridianNode &last = shape.meridian[4], &end = shape.meridian.back();
    EXPECT_NEAR(end.s, last.s + options.gage_length, rounding);
    EXPECT_NEAR(end.top.z, last.top.z - options.gage_length, rounding);
    EXPECT_EQ(end.top.r, last.top.r);
    EXPECT_NEAR(end.floor.r, end.top.r - options.slot_depth, rounding);
  }
}

/// Of a cutter that stands between two face cutters, wherever.
TEST(BladeShape, knows_the_place_of_a_cutter_between_others) {
  const auto cutters = on_a_cone(0.3);
  const BladeShape shape = blade_shape(cutters, {});
  for (std::size_t k = 1; k < cutters.size(); ++k) {
    Cutter c = cutters[k];
    c.tip_radius = 0.4 * cutters[k - 1].tip_radius + 0.6 * cutters[k].tip_radius;
    c.tip_height = std::tan(0.3) * c.tip_radius;
    EXPECT_NEAR(place_of(shape, c), c.tip_radius / std::cos(0.3), rounding);
  }
}

}  // namespace tdbd::bit::blade_shape_test

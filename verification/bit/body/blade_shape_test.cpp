#include "bit/body/blade_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"

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

/// The position of a cutter between any two face cutters.
TEST(BladeShape, finds_the_place_of_a_cutter_between_others) {
  const auto cutters = on_a_cone(0.3);
  const BladeShape shape = blade_shape(cutters, {});
  for (std::size_t k = 1; k < cutters.size(); ++k) {
    Cutter c = cutters[k];
    c.tip_radius = 0.4 * cutters[k - 1].tip_radius + 0.6 * cutters[k].tip_radius;
    c.tip_height = std::tan(0.3) * c.tip_radius;
    EXPECT_NEAR(place_of(shape, c), c.tip_radius / std::cos(0.3), rounding);
  }
}

/// A flat bit's sharp cutters without rakes, at these radii and azimuths: place and radius are the same.
std::vector<Cutter> flat(const std::vector<std::pair<double, double>>& places) {
  std::vector<Cutter> cutters;
  for (const auto& [radius, azimuth] : places) {
    Cutter c;
    c.blade = 1;
    c.diameter = 16e-3;
    c.length = 13e-3;
    c.tip_radius = radius;
    c.azimuth = azimuth;
    c.X_BC = cutter_pose(c);
    cutters.push_back(c);
  }
  return cutters;
}

/// The front follows the cutters' azimuths without jumps of a turn, and ends within one.
TEST(BladeShape, has_fronts_without_jumps) {
  const BladeShape shape =
      blade_shape(flat({{0.02, 6.2}, {0.03, 0.1}, {0.04, 6.0}, {0.05, 0.3}}), {});
  const BladeStrip& blade = shape.blades.at(0);
  ASSERT_EQ(blade.front.size(), 4U);
  const double azimuths[] = {6.2 - full_turn, 0.1, 6.0 - full_turn, 0.3};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(blade.front[k].first, 0.02 + 0.01 * static_cast<double>(k), rounding);
    EXPECT_NEAR(blade.front[k].second, azimuths[k], 2e-15);
  }
  EXPECT_NEAR(front_at(blade, 0.0), azimuths[0], 2e-15);  // before the first and after the last
  EXPECT_NEAR(front_at(blade, 0.09), azimuths[3], 2e-15);
  EXPECT_NEAR(front_at(blade, 0.0325), 0.75 * azimuths[1] + 0.25 * azimuths[2], 2e-15);
  EXPECT_NEAR(front_at(blade, blade.front[2].first), azimuths[2], 2e-15);
  const BladeShape later = blade_shape(flat({{0.02, 0.1}, {0.03, -0.2}}), {});
  EXPECT_NEAR(later.blades[0].front[1].second, full_turn - 0.2, 2e-15);
  EXPECT_NEAR(later.blades[0].front[0].second, full_turn + 0.1, 2e-15);
}

/// A cutter on the front trails by its length, one ahead of it or behind it by less or more; a blade without a
/// width is 2 mm wider than its cutters need, and starts three quarters of a diameter before the first tip.
TEST(BladeShape, makes_blades_as_wide_as_their_cutters_need) {
  const auto straight = flat({{0.03, 1.0}, {0.05, 1.0}});
  const BladeStrip blade = blade_shape(straight, {}).blades.at(0);
  for (const Cutter& c : straight) EXPECT_NEAR(trail_of(blade, c, c.tip_radius), 13e-3, rounding);
  EXPECT_NEAR(blade.width, 13e-3 + 2e-3, rounding);
  EXPECT_NEAR(blade.start, 0.03 - 0.75 * 16e-3, rounding);
  const Cutter behind = flat({{0.05, 0.8}})[0];
  EXPECT_NEAR(trail_of(blade, behind, 0.05), 0.05 * std::sin(0.2) + 13e-3 * std::cos(0.2),
              rounding);
  EXPECT_EQ(blade_shape(straight, {.width = 9e-3}).blades[0].width, 9e-3);
}

/// Backups count for a blade's width, face cutters for its front; without any all cutters are the front.
TEST(BladeShape, is_led_by_its_face_cutters) {
  auto cutters = flat({{0.03, 1.0}, {0.05, 1.0}, {0.05, 0.6}});
  cutters[2].under_exposure = 1e-3;
  cutters[2].tip_height = 1e-3;
  cutters[2].X_BC = cutter_pose(cutters[2]);
  const BladeStrip blade = blade_shape(cutters, {}).blades.at(0);
  EXPECT_EQ(blade.front.size(), 2U);
  EXPECT_NEAR(blade.width, 0.05 * std::sin(0.4) + 13e-3 * std::cos(0.4) + 2e-3, rounding);
  for (Cutter& c : cutters) c.under_exposure = 1e-3;
  EXPECT_EQ(blade_shape(cutters, {}).blades.at(0).front.size(), 3U);
}

/// From the blade's top over a wall of 4 mm to the slot's floor: ahead of the front, behind the width, and
/// towards the axis.
TEST(BladeShape, falls_from_its_blades_over_their_walls) {
  const BladeOptions options{.exposure = 3e-3, .slot_depth = 10e-3, .width = 9e-3, .wall = 4e-3};
  const BladeShape shape = blade_shape(flat({{0.03, 1.0}, {0.05, 1.0}}), options);
  EXPECT_EQ(shape.wall, 4e-3);
  const double r = 0.04;
  const MeridianNode at = meridian_at(shape, r);
  EXPECT_NEAR(at.top.r, r, rounding);
  EXPECT_NEAR(at.top.z, -3e-3, rounding);
  EXPECT_NEAR(at.floor.z, -13e-3, rounding);
  const auto share_ahead = [&](double y) { return sunk_share(shape, at, 1.0 + std::asin(y / r)); };
  constexpr double small = 1e-12;  // of lengths over the wall
  EXPECT_NEAR(share_ahead(1e-3), 0.25, small);
  EXPECT_NEAR(share_ahead(-12e-3), 0.75, small);
  for (const double y : {-1e-3, -8.999e-3}) EXPECT_EQ(share_ahead(y), 0.0);
  for (const double y : {4.001e-3, -13.001e-3, 0.03}) EXPECT_EQ(share_ahead(y), 1.0);
  EXPECT_EQ(sunk_share(shape, at, 1.0 + pi), 1.0);       // before the blade starts
  const MeridianNode inner = meridian_at(shape, 0.016);  // 2 mm before the start
  EXPECT_NEAR(sunk_share(shape, inner, 1.0), 0.5, small);
  const Vec3 x = surface_point_B(shape, at, 1.0 + std::asin(1e-3 / r));
  EXPECT_NEAR(x.head<2>().norm(), r, rounding);
  EXPECT_NEAR(std::atan2(x.y(), x.x()), 1.0 + std::asin(1e-3 / r), 1e-14);
  EXPECT_NEAR(x.z(), -3e-3 - 0.25 * 10e-3, 1e-14);
}

/// Blades come by the azimuths of their fronts at the gage, whatever their numbers.
TEST(BladeShape, has_its_blades_in_their_order_around_the_bit) {
  auto cutters = flat({{0.05, 5.0}, {0.051, 1.0}, {0.052, 3.0}});
  for (int k = 0; k < 3; ++k) cutters[static_cast<std::size_t>(k)].blade = k + 1;
  const BladeShape shape = blade_shape(cutters, {});
  ASSERT_EQ(shape.blades.size(), 3U);
  EXPECT_EQ(shape.blades[0].blade, 2);
  EXPECT_EQ(shape.blades[1].blade, 3);
  EXPECT_EQ(shape.blades[2].blade, 1);
}

}  // namespace tdbd::bit::blade_shape_test

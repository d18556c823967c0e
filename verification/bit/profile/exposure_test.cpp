#include "bit/profile/exposure.hpp"

#include <gtest/gtest.h>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/generate.hpp"

namespace tdbd::bit::exposure_test {

constexpr double radius = 0.01;     ///< m
constexpr double of_chords = 3e-8;  ///< m: sagitta of the rim's chords, radius (pi/1440)^2 / 2

/// A flat, sharp cutter of 20 mm without rakes on a profile that falls outwards by `angle`.
Cutter flat_cutter(double tip_radius, double height, double angle = 0.0) {
  Cutter c;
  c.diameter = 2.0 * radius;
  c.length = 0.01;
  c.tip_radius = tip_radius;
  c.tip_height = height;
  c.profile_angle = angle;
  c.azimuth = 0.7 * tip_radius / radius;
  c.X_BC = cutter_pose(c);
  return c;
}

RC_GTEST_PROP(Exposure, of_two_equal_cutters_side_by_side_is_the_height_between_circles, ()) {
  const double apart = number(0.01, 0.95) * radius, angle = number(-0.5, 1.2);
  const double r = 0.05 + apart * std::cos(angle), h = apart * std::sin(angle);
  const auto found = exposures({flat_cutter(0.05, 0.0, angle), flat_cutter(r, h, angle)});
  const double expected = radius - std::sqrt(radius * radius - apart * apart);
  const double steepness = apart / std::sqrt(radius * radius - apart * apart);
  for (const double e : found)
    RC_ASSERT(std::abs(e - expected) < of_chords * (1.0 + steepness * steepness));
}

TEST(Exposure, of_a_backup_behind_its_cutter_is_its_under_exposure) {
  const auto found = exposures({flat_cutter(0.05, 0.0), flat_cutter(0.05, 1e-3)});
  EXPECT_NEAR(found[0], 1e-3, 1e-15);
  EXPECT_NEAR(found[1], -1e-3, 1e-15);
}

TEST(Exposure, is_not_told_where_no_other_rim_is_near) {
  EXPECT_TRUE(std::isnan(exposures({flat_cutter(0.05, 0.0)})[0]));
  const auto far = exposures({flat_cutter(0.05, 0.0), flat_cutter(0.05 + 2.01 * radius, 0.0)});
  EXPECT_TRUE(std::isnan(far[0]) && std::isnan(far[1]));
  EXPECT_TRUE(exposures({}).empty());
}

}  // namespace tdbd::bit::exposure_test

#include "bit/pdc/profile_design.hpp"

#include <gtest/gtest.h>

#include "bit/generate_design.hpp"

namespace tdbd::bit::profile_design_test {

/// The three profiles of cases/bits: their shoulders and heights in mm, to the tenth that is known.
TEST(ProfileDesign, of_the_example_bits_has_their_shoulders_and_heights) {
  const auto check = [](double cone, double place, double nose, double start, double shoulder,
                        double height) {
    const ProfileDesign p{107.95e-3,   cone * degree,  place * 1e-3,
                          nose * 1e-3, start * degree, 0.05};
    EXPECT_NEAR(1e3 * shoulder_radius(p), shoulder, 0.05);
    EXPECT_NEAR(1e3 * spot_at(p, region_ends(p)[2]).h, height, 0.05);
    EXPECT_NEAR(shoulder_angle_for(p, shoulder_radius(p)), start * degree, 1e-13);
  };
  check(18, 66, 38, 35, 47.3, 45.6);
  check(15, 62, 34, 32, 59.4, 55.6);
  check(22, 70, 34, 38, 44.3, 42.1);
}

/// A design whose every length is a round number: a flat cone and quarter arcs.
TEST(ProfileDesign, of_quarter_arcs_is_computed_by_hand) {
  const ProfileDesign p{0.1, 0.0, 0.04, 0.02, 0.0, 0.03};
  EXPECT_NEAR(shoulder_radius(p), 0.06, 1e-16);
  const auto ends = region_ends(p);
  EXPECT_NEAR(ends[0], 0.04, 1e-16);
  EXPECT_NEAR(ends[1], 0.04, 1e-16);
  EXPECT_NEAR(ends[2], 0.04 + 0.03 * pi, 1e-16);
  EXPECT_NEAR(ends[3], 0.07 + 0.03 * pi, 1e-16);
  const ProfileSpot half = spot_at(p, 0.04 + 0.015 * pi);
  EXPECT_NEAR(half.r, 0.04 + 0.06 * std::sqrt(0.5), 1e-16);
  EXPECT_NEAR(half.h, 0.06 * (1 - std::sqrt(0.5)), 1e-16);
  EXPECT_NEAR(half.angle, pi / 4, 1e-15);
}

/// Central differences over ds: the curve's tangent is the one that the angle tells, and s is its
/// arc length. Error (ds/radius)^2 / 6 at most; across the regions' ends ds/radius.
RC_GTEST_PROP(ProfileDesign, is_a_smooth_curve_in_arc_length, ()) {
  const ProfileDesign p = any_profile();
  const double ds = 1e-6 * p.gage_radius, end = region_ends(p)[3];
  const double s = number(0.001, 0.999) * end;
  const ProfileSpot a = spot_at(p, s - ds), b = spot_at(p, s + ds), here = spot_at(p, s);
  RC_ASSERT(std::abs((b.r - a.r) / (2 * ds) - std::cos(here.angle)) < 3.4e-10);
  RC_ASSERT(std::abs((b.h - a.h) / (2 * ds) - std::sin(here.angle)) < 4.8e-10);
}

RC_GTEST_PROP(ProfileDesign, starts_on_the_axis_touches_zero_and_reaches_the_gage, ()) {
  const ProfileDesign p = any_profile();
  const auto ends = region_ends(p);
  RC_ASSERT(spot_at(p, 0.0).r == 0.0);
  const double lowest = ends[0] + p.nose_radius * p.cone_angle;
  RC_ASSERT(std::abs(spot_at(p, lowest).h) < 1e-15);
  RC_ASSERT(std::abs(spot_at(p, lowest).r - p.nose_place) < 1e-15);
  RC_ASSERT(std::abs(spot_at(p, ends[2] * (1 - 1e-15)).r - p.gage_radius) < 1e-15);
  RC_ASSERT(spot_at(p, ends[3]).r == p.gage_radius);
}

}  // namespace tdbd::bit::profile_design_test

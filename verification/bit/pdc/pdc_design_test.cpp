#include "bit/pdc/pdc_design.hpp"

#include <gtest/gtest.h>

#include <array>

#include "bit/generate_design.hpp"

namespace tdbd::bit::pdc_design_test {

/// The first problem of the plain design after a change: "key: found, expected".
template <class Change>
std::string problem_after(Change change) {
  PdcDesign d = plain_design();
  change(d);
  const Layout layout = make_layout(d);
  if (layout.problems.empty()) return "";
  const DesignProblem& p = layout.problems.front();
  return p.key + ": " + p.found + ", " + p.expected;
}

TEST(PdcDesign, has_no_problem_at_first) {
  EXPECT_EQ(problem_after([](PdcDesign&) {}), "");
}

TEST(PdcDesign, may_not_fold) {
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.profile.nose_place = 0.09; }),
            "profile.shoulder_angle: 35 deg, a profile that folds: the nose's arc ends at radius "
            "111.796 mm, outside the gage at 107.95 mm, a smaller angle, a smaller nose_radius or "
            "a smaller nose_place");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.profile.nose_place = 0.01; }),
            "profile.nose_radius: 38 mm, a nose that begins at radius -1.74265 mm, across the "
            "axis, at most 32.3607 mm");
}

TEST(PdcDesign, may_not_have_its_nose_outside_the_gage) {
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.profile.nose_place = 0.12; }),
            "profile.nose_place: 120 mm from the axis, a nose between the axis and the gage at "
            "107.95 mm");
}

TEST(PdcDesign, may_not_have_sizes_that_are_no_sizes) {
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.diameter.shoulder = -0.01; }),
            "diameter.shoulder: -10 mm, a positive diameter, more than twice the chamfers' width");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.profile.nose_radius = 0.0; }),
            "profile.nose_radius: 0 mm, a positive radius");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.overlap.nose = 1.0; }),
            "overlap.nose: 1, a share in 0..0.95");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.wear.gage = 0.01; }),
            "wear.gage: 10, a height in mm from 0 to a cutter's radius");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.back_rake.axis = 61 * degree; }),
            "back_rake.axis: 61, an angle in -5..60 deg");
}

TEST(PdcDesign, needs_blades_and_cutters_for_each) {
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.blades.clear(); }),
            "blades: none, at least one blade");
  EXPECT_EQ(problem_after([](PdcDesign& d) {
              d.blades.push_back({0.5, 0.2, Backups::none});
              d.gage.cutters = 0;
            }),
            "blades[6]: blade 7 without any cutter, fewer blades, more overlap or smaller cutters");
}

TEST(PdcDesign, reports_which_cutters_are_in_the_way) {
  const std::string message = problem_after([](PdcDesign& d) { d.overlap.axis = 0.8; });
  EXPECT_EQ(message.rfind("overlap: no blade with room for cutter ", 0), 0u) << message;
  EXPECT_NE(message.find("on blade 3 cutter "), std::string::npos) << message;
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.gage.start = 0.2; }),
            "gage.start: cutter 33 (gage, blade 1, radius 107.95 mm) overlapping cutter 32 "
            "(gage, blade 1, radius 107.95 mm), 0.5 mm of clearance");
  EXPECT_EQ(problem_after([](PdcDesign& d) { d.gage.cutters = 4; }),
            "gage.cutters: gage cutter 3 reaching 51.072 mm up the gage, at most the gage's "
            "length, 50 mm");
}

/// From the axis to the ends of cone, nose and shoulder its four values, linear between them along the profile, and
/// the last all along the gage.
RC_GTEST_PROP(LawAt, is_linear_from_end_to_end_of_the_regions, ()) {
  const ProfileDesign p = any_profile();
  const RegionLaw law = any_law(-1.0, 1.0);
  const std::array<double, 4> ends = region_ends(p);
  const std::array<double, 5> s{0.0, ends[0], ends[1], ends[2], ends[3]},
      value{law.axis, law.nose, law.shoulder, law.gage, law.gage};
  const std::size_t k = *rc::gen::inRange<std::size_t>(0, 4);
  const double w = number(0.0, 0.999);
  constexpr double rounding = 3e-13;  // of places beside the shortest region's length
  RC_ASSERT(std::abs(law_at(law, p, s[k] + w * (s[k + 1] - s[k])) -
                     ((1.0 - w) * value[k] + w * value[k + 1])) < rounding);
}

TEST(ChoiceIn, has_one_value_in_each_region) {
  const RegionChoice choice{1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(choice_in(choice, Region::cone), 1.0);
  EXPECT_EQ(choice_in(choice, Region::nose), 2.0);
  EXPECT_EQ(choice_in(choice, Region::shoulder), 3.0);
  EXPECT_EQ(choice_in(choice, Region::gage), 4.0);
}

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
TEST(ProfileDesign, of_quarter_arcs_is_the_one_computed_manually) {
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

/// Central differences over ds: the tangent of the curve is that of the angle, and s is its arc
/// length. Error (ds/radius)^2 / 6 at most; across the regions' ends ds/radius.
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

}  // namespace tdbd::bit::pdc_design_test

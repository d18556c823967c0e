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
  const Layout layout = lay_out(d);
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

TEST(PdcDesign, says_which_cutters_are_in_the_way) {
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

}  // namespace tdbd::bit::pdc_design_test

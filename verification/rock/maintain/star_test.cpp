#include "rock/maintain/star.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::star_test {

MaintenanceLimits limits_with(double overhang) {
  MaintenanceLimits limits;
  limits.steepest_overhang = overhang;
  limits.least_normal_cosine = -1.0;  // any turn
  return limits;
}

/// z is down: a triangle whose normal points down hangs over. Areas in mm2 or m2 are judged alike.
RC_GTEST_PROP(JudgeTurn, knows_directions_alone, ()) {
  MaintenanceLimits limits = limits_with(*battery::number(0.0, 0.5));
  limits.least_normal_cosine = *battery::number(-1.0, 1.0);
  const Vec3 before = *battery::point(1.0), after = *battery::point(1.0);
  const double small = std::pow(10.0, *battery::number(-9.0, 0.0)),
               large = std::pow(10.0, *battery::number(0.0, 3.0));
  RC_ASSERT(judge_turn(small * before, large * after, limits) == judge_turn(before, after, limits));
}

/// A unit normal that leans over by this sine.
Vec3 leaning(double sine) { return {std::sqrt(1.0 - sine * sine), 0.0, sine}; }

TEST(JudgeTurn, lets_upright_triangles_lean_a_little_and_others_not_at_all) {
  const MaintenanceLimits limits = limits_with(0.1);
  const auto judge = [&](double from, double to) {
    return judge_turn(1e-6 * leaning(from), 2e-6 * leaning(to), limits);
  };
  EXPECT_FALSE(judge(0.0, 0.09));
  EXPECT_EQ(judge(0.0, 0.11), Refusal::overhang);
  EXPECT_EQ(judge(0.09, 0.11), Refusal::overhang);
  EXPECT_FALSE(judge(0.11, 0.2));    // it hung over before
  EXPECT_FALSE(judge(-0.09, 0.05));  // it stood upright
  EXPECT_EQ(judge(-0.2, 0.05), Refusal::overhang);
  EXPECT_FALSE(judge(-0.2, -0.05));
}

TEST(JudgeTurn, refuses_to_turn_a_normal_far) {
  MaintenanceLimits limits = limits_with(2.0);
  limits.least_normal_cosine = 0.5;
  const Vec3 up(0.0, 0.0, -3e-6);
  EXPECT_FALSE(judge_turn(up, Vec3(0.8e-6, 0.0, -0.6e-6), limits));
  EXPECT_EQ(judge_turn(up, Vec3(0.9e-6, 0.0, -0.4e-6), limits), Refusal::normal);
}

}  // namespace tdbd::rock::star_test

#include "bit/cone/cone_reach.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_frame.hpp"
#include "bit/cone_generate.hpp"
#include "core/error.hpp"

namespace tdbd::bit::cone_reach_test {
namespace {

Vec3 on_circle(const Pose& X_BK, const ShellPoint& p, double angle) {
  return X_BK * Vec3(p.r * std::cos(angle), p.r * std::sin(angle), -p.s);
}

/// No place of a point's circle is farther out or deeper than told, and some are as far but for what lies
/// between two of the many that are looked at.
RC_GTEST_PROP(ConeReach, is_the_farthest_and_the_deepest_of_a_circle, ()) {
  const Pose X_BK = cone_pose(any_cone(), 0.0);
  const ShellPoint p{number(-0.05, 0.12), number(1e-3, 0.08)};
  const ConeReach reach = reach_of(X_BK, p);
  constexpr int n = 4000;
  constexpr double between = 1e-7;  // m: p.r (pi / n)^2 / 2, and what curves more
  double radius = 0.0, depth = -1.0;
  for (int k = 0; k < n; ++k) {
    const Vec3 x = on_circle(X_BK, p, full_turn * k / n);
    radius = std::max(radius, x.head<2>().norm());
    depth = std::max(depth, x.z());
  }
  RC_ASSERT(reach.radius >= radius - 1e-15);
  RC_ASSERT(reach.radius < radius + between);
  RC_ASSERT(reach.depth >= depth - 1e-15);
  RC_ASSERT(reach.depth < depth + between);
  RC_ASSERT(std::abs(on_circle(X_BK, p, reach.angle).head<2>().norm() - reach.radius) < 1e-15);
}

/// Of a meridian it is that of its farthest corner, and the depth of its deepest, whichever they are.
RC_GTEST_PROP(ConeReach, of_a_meridian_is_that_of_its_corners, ()) {
  const Pose X_BK = cone_pose(any_cone(), 0.0);
  Meridian m;
  for (int i = 0, count = *rc::gen::inRange(1, 6); i < count; ++i)
    m.push_back({number(-0.05, 0.12), number(1e-3, 0.08)});
  const ConeReach all = reach_of(X_BK, m);
  double radius = 0.0, depth = -1.0, angle = 0.0;
  for (const ShellPoint& p : m) {
    const ConeReach one = reach_of(X_BK, p);
    if (one.radius > radius) angle = one.angle;
    radius = std::max(radius, one.radius);
    depth = std::max(depth, one.depth);
  }
  RC_ASSERT(all.radius == radius);
  RC_ASSERT(all.depth == depth);
  RC_ASSERT(all.angle == angle);
}

/// With the apex that it finds the gage row reaches the gage, whatever the others reach.
TEST(ApexForGage, brings_the_gage_row_to_the_gage) {
  ConeLayout cone;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow inner, gage;
  inner.s = 0.065;  // which reaches farther
  inner.angles = {0.0};
  inner.shape.protrusion = 0.05;
  gage.s = 0.08;
  gage.angles = {0.0};
  gage.place = RowPlace::gage;
  cone.rows = {inner, gage};
  for (const auto& [journal, offset, radius] :
       {std::tuple(0.6, 0.0, 0.1), {0.3, 5e-3, 0.12}, {1.0, -8e-3, 0.09}}) {
    cone.journal_angle = journal;
    cone.offset = offset;
    cone.apex = apex_for_gage(cone, radius);
    const ConeReach reach = reach_of(cone_pose(cone, 0.0), row_meridian(cone, gage));
    EXPECT_NEAR(reach.radius, radius, 1e-13);
  }
}

TEST(ApexForGage, says_where_there_is_none) {
  ConeLayout cone;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow gage;
  gage.s = 0.08;
  gage.angles = {0.0};
  gage.place = RowPlace::gage;
  cone.rows = {gage};
  try {
    apex_for_gage(cone, 0.005);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "no place along the journal at which the gage row reaches 5.000 mm");
  }
}

}  // namespace
}  // namespace tdbd::bit::cone_reach_test

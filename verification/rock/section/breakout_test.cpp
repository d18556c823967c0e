#include "rock/section/breakout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angles.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::breakout_test {
namespace {

double within(double lo, double hi) {
  return lo + (hi - lo) * static_cast<double>(*rc::gen::inRange(0, 1000001)) / 1e6;
}

/// A regular polygon with its lowest corner at (0, 0).
ConvexPolygon round_face(double radius, int corners) {
  ConvexPolygon rim;
  for (int i = 0; i < corners; ++i) {
    const double t = 2.0 * std::numbers::pi * i / corners;
    rim.emplace_back(radius * std::sin(t), radius * (1.0 - std::cos(t)));
  }
  return rim;
}

/// With any rakes, a crack of this slope in the plane of the face has its angle with the normal,
/// seen along the motion.
RC_GTEST_PROP(CrackSlope, is_seen_at_its_angle_along_the_motion, ()) {
  const double back = within(0.0, 0.6), tilt = within(-0.3, 0.3), angle = within(0.2, 1.2);
  Pose X;
  const Vec3 along = Vec3::UnitX(), normal = Vec3::UnitZ();
  const Vec3 z = std::sin(back) * along - std::cos(back) * normal,
             x0 = std::cos(back) * along + std::sin(back) * normal, y0 = z.cross(x0);
  X.R.col(0) = std::cos(tilt) * x0 + std::sin(tilt) * y0;
  X.R.col(1) = std::cos(tilt) * y0 - std::sin(tilt) * x0;
  X.R.col(2) = z;
  for (const FaceSide side : {FaceSide::left, FaceSide::right}) {
    const double slope = crack_slope(X, side, along, normal, angle);
    if (slope <= 0.0) continue;
    const double sign = side == FaceSide::left ? -1.0 : 1.0;
    const Vec3 crack = X.R * Vec3(0.0, sign * slope, 1.0);
    const double up = -crack.dot(normal), sideways = std::abs(crack.y());
    RC_ASSERT(std::abs(std::atan2(sideways, up) - angle) < 1e-12);
  }
}

TEST(CrackSlope, of_a_face_without_rakes_is_the_tangent) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  for (const FaceSide side : {FaceSide::left, FaceSide::right})
    EXPECT_NEAR(crack_slope(X, side, Vec3::UnitX(), Vec3::UnitZ(), 60.0 * degree), std::sqrt(3.0),
                1e-15);
}

/// Where cracks from all points of the edge in rock reach at a height, by many points.
double reach_by_points(const Breakout& b, double end_z, double sign) {
  const ConvexPolygon& edge = sign < 0.0 ? b.left_F : b.right_F;
  const double top = std::min(end_z, edge.back().y()), lowest = edge.front().y();
  const double start = top - b.share * (top - lowest);
  double reach = -INFINITY;
  for (std::size_t i = 0; i + 1 < edge.size(); ++i)
    for (int k = 0; k <= 2000; ++k) {
      const Vec2 x = edge[i] + k / 2000.0 * (edge[i + 1] - edge[i]);
      if (x.y() >= start - 1e-15 && x.y() <= top + 1e-15)
        reach = std::max(reach, sign * x.x() + b.slope * (top - x.y()));
    }
  return reach;
}

RC_GTEST_PROP(CrackStart, is_from_where_a_crack_reaches_farthest, ()) {
  const double radius = 1.0;
  const ConvexPolygon rim = round_face(radius, *rc::gen::inRange(8, 80));
  Breakout b;
  b.left_F = lower_edge(rim, FaceSide::left);
  b.right_F = lower_edge(rim, FaceSide::right);
  b.slope = within(0.1, 5.0);
  b.share = within(0.01, 1.0);
  const double end = within(0.01, 1.5), top = std::min(end, b.right_F.back().y());
  for (const BreakoutPlace place : {BreakoutPlace::left, BreakoutPlace::right}) {
    b.place = place;
    const double sign = place == BreakoutPlace::left ? -1.0 : 1.0;
    const auto start = crack_start(b, end);
    const double by_points = reach_by_points(b, end, sign);
    if (!start) {
      double edge_at_top = 0.0;
      for (std::size_t i = 0; i + 1 < b.right_F.size(); ++i)
        if (const Vec2& p = b.right_F[i], &q = b.right_F[i + 1]; p.y() <= top && top <= q.y())
          edge_at_top = p.x() + (top - p.y()) / std::max(q.y() - p.y(), 1e-300) * (q.x() - p.x());
      RC_ASSERT(by_points <= edge_at_top + 1e-12);
      continue;
    }
    const double reach = sign * start->x() + b.slope * (top - start->y());
    RC_ASSERT(reach >= by_points - 1e-12);
    RC_ASSERT(reach <= by_points + 2e-3 * (1.0 + b.slope));
    RC_ASSERT(start->y() >= top - b.share * top - 1e-12);
    RC_ASSERT(sign * start->x() >= 0.0);
  }
}

/// On a shallow cut by a round face the groove is flatter than a steep crack.
TEST(CrackStart, is_none_where_the_groove_is_flatter_than_the_crack) {
  Breakout b;
  b.right_F = lower_edge(round_face(1.0, 64), FaceSide::right);
  b.place = BreakoutPlace::right;
  b.slope = std::tan(60.0 * degree);
  EXPECT_FALSE(crack_start(b, 0.1));
  EXPECT_TRUE(crack_start(b, 0.2));
}

TEST(LowerEdge, rises_from_the_lowest_point_to_the_widest) {
  const ConvexPolygon rim = round_face(1.0, 8);
  const ConvexPolygon left = lower_edge(rim, FaceSide::left),
                      right = lower_edge(rim, FaceSide::right);
  ASSERT_EQ(left.size(), 3U);
  ASSERT_EQ(right.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(left[i].x(), -right[i].x(), 1e-15);
    EXPECT_NEAR(left[i].y(), right[i].y(), 1e-15);
  }
  EXPECT_NEAR(right.back().x(), 1.0, 1e-15);
}

TEST(RaisedAhead, is_the_share_that_is_left_of_the_deeper_side) {
  Breakout b;
  b.left_F = b.right_F = {{0.0, -3.0}, {1.0, 0.0}};
  b.place = BreakoutPlace::ahead;
  b.share = 0.25;
  EXPECT_FALSE(raised_ahead(b, {}));
  EXPECT_DOUBLE_EQ(*raised_ahead(b, {-2.0, -1.0}), 1.5);
  EXPECT_DOUBLE_EQ(*raised_ahead(b, {std::nullopt, -1.0}), 1.5);
}

}  // namespace
}  // namespace tdbd::rock::breakout_test

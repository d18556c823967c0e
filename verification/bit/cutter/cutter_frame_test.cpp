#include "bit/cutter/cutter_frame.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"

namespace tdbd::bit::cutter_frame_test {

/// Direction of motion at the cutter's azimuth: the bit turns about +z.
Vec3 motion_B(const Cutter& c) {
  return Vec3::UnitZ().cross(Vec3(std::cos(c.azimuth), std::sin(c.azimuth), 0.0));
}

RC_GTEST_PROP(CutterFrame, is_right_handed_and_orthonormal, ()) {
  const Mat3 R = any_cutter().X_BC.R;
  RC_ASSERT((R.transpose() * R - Mat3::Identity()).norm() < 1e-14);
  RC_ASSERT(std::abs(R.determinant() - 1.0) < 1e-14);
}

RC_GTEST_PROP(CutterFrame, puts_the_tip_where_the_table_says, ()) {
  const Cutter c = any_cutter();
  const Vec3 expected(c.tip_radius * std::cos(c.azimuth), c.tip_radius * std::sin(c.azimuth),
                      -c.tip_height);
  RC_ASSERT((c.X_BC * tip_C(c) - expected).norm() < 1e-15);
}

/// A steep chamfer (a small angle from the axis) is deep, a flat one shallow.
TEST(CutterFrame, measures_the_chamfer_from_the_axis) {
  Cutter c;
  c.chamfer = 1e-3;
  c.chamfer_angle = 60 * degree;
  EXPECT_NEAR(chamfer_depth(c), 1e-3 / std::sqrt(3.0), 1e-18);
}

/// -Z is tilted from n by the back rake, backwards, whatever the side rake.
RC_GTEST_PROP(CutterFrame, leans_over_the_rock_by_the_back_rake, ()) {
  const Cutter c = any_cutter();
  const Vec3 exposure_B = -c.X_BC.R.col(2);
  RC_ASSERT(std::abs(exposure_B.dot(profile_normal_B(c)) - std::cos(c.back_rake)) < 1e-15);
  RC_ASSERT(std::abs(exposure_B.dot(motion_B(c)) + std::sin(c.back_rake)) < 1e-15);
}

RC_GTEST_PROP(CutterFrame, turns_the_face_by_the_side_rake, ()) {
  Cutter c = any_cutter();
  const Vec3 x_B = c.X_BC.R.col(0);
  const double side_rake = std::exchange(c.side_rake, 0.0);
  const Pose straight = cutter_pose(c);
  RC_ASSERT(std::abs(x_B.dot(straight.R.col(0)) - std::cos(side_rake)) < 1e-14);
  RC_ASSERT(std::abs(x_B.dot(straight.R.col(1)) - std::sin(side_rake)) < 1e-14);
  RC_ASSERT(std::abs(straight.R.col(1).dot(profile_normal_B(c))) < 1e-15);
}

/// The rim, followed finely: nothing on it reaches farther along n than the tip, but for the
/// documented excess that a side rake makes.
RC_GTEST_PROP(CutterFrame, tip_is_the_farthest_point_of_the_edge, ()) {
  const Cutter c = any_cutter();
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double ss = std::sin(c.side_rake), sb = std::sin(c.back_rake), cb = std::cos(c.back_rake);
  const double excess = 0.5 * c.diameter * (std::sqrt(cb * cb + ss * ss * sb * sb) - cb);
  double farthest = -1.0;
  for (int k = 0; k < 3600; ++k) {
    const double a = k * 2 * pi / 3600;
    const Vec3 rim_C(tip_C(c).x(), tip_C(c).z() * std::sin(a), tip_C(c).z() * std::cos(a));
    farthest = std::max(farthest, n_C.dot(rim_C - tip_C(c)));
  }
  RC_ASSERT(farthest <= excess + 1e-15);
  RC_ASSERT(farthest >= excess - 1e-8);
}

}  // namespace tdbd::bit::cutter_frame_test

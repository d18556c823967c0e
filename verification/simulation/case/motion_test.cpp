#include "simulation/case/motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/doubtful_values.hpp"

namespace tdbd::simulation::motion_test {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-14;  ///< some ulps of numbers of size one

Motion steady() {
  Motion m;
  m.rotary_speed = 4.0 * pi;
  m.rate_of_penetration = 0.004;
  return m;
}

Motion whirling(WhirlSense sense) {
  Motion m = steady();
  m.kind = MotionKind::whirl;
  m.whirl = {0.002, 30.0, sense, 0.5};
  return m;
}

Motion along(std::vector<PathPoint> path) {
  Motion m;
  m.kind = MotionKind::table;
  m.path = std::move(path);
  sum_turns(m.path);
  return m;
}

Mat3 turn_about_z(double angle) {
  Mat3 R;
  R << std::cos(angle), -std::sin(angle), 0.0, std::sin(angle), std::cos(angle), 0.0, 0.0, 0.0, 1.0;
  return R;
}

TEST(Motion, steady_pose_is_the_closed_form) {
  for (const double t : {0.0, 0.001, 0.1, 0.7, 12.3}) {
    const Pose X_WB = pose_at(steady(), t);
    EXPECT_LE((X_WB.R - turn_about_z(4.0 * pi * t)).norm(), rounding * (1.0 + 4.0 * pi * t));
    EXPECT_EQ(X_WB.p, Vec3(0.0, 0.0, 0.004 * t));
    EXPECT_EQ(angle_turned(steady(), t), 4.0 * pi * t);
  }
}

TEST(Motion, whirl_circles_at_its_radius_frequency_and_sense) {
  for (const WhirlSense sense : {WhirlSense::forward, WhirlSense::backward}) {
    const Motion m = whirling(sense);
    const double sign = sense == WhirlSense::forward ? 1.0 : -1.0;
    for (const double t : {0.5, 0.61, 1.7, 4.0}) {
      const Vec3 p = pose_at(m, t).p, later = pose_at(m, t + 0.01).p;
      EXPECT_NEAR(p.head<2>().norm(), 0.002, 1e-15);
      const double turned = std::atan2(p.cross(later).z(), p.head<2>().dot(later.head<2>()));
      EXPECT_NEAR(turned, sign * 30.0 * 0.01, rounding);
    }
  }
}

/// The orbit shifts the bit; turning and drilling are those of the steady motion.
TEST(Motion, whirl_adds_nothing_but_the_orbit) {
  const Motion m = whirling(WhirlSense::backward);
  for (const double t : {0.0, 0.3, 2.2}) {
    EXPECT_EQ(pose_at(m, t).R, pose_at(steady(), t).R);
    EXPECT_EQ(pose_at(m, t).p.z(), pose_at(steady(), t).p.z());
    EXPECT_EQ(angle_turned(m, t), angle_turned(steady(), t));
  }
}

TEST(Motion, whirl_grows_linearly_over_its_ramp) {
  const Motion m = whirling(WhirlSense::forward);
  for (const double part : {0.0, 0.25, 0.5, 1.0})
    EXPECT_NEAR(pose_at(m, 0.5 * part).p.head<2>().norm(), 0.002 * part, 1e-17);
  Motion at_once = m;
  at_once.whirl.ramp = 0.0;
  EXPECT_EQ(pose_at(at_once, 0.0).p, Vec3(0.002, 0.0, 0.0));
}

Vec3 arbitrary(const std::uint64_t seed, double size) {
  Random random{seed};
  return size *
         Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
}

RC_GTEST_PROP(Motion, a_path_passes_through_its_rows, (std::uint64_t seed)) {
  std::vector<PathPoint> path;
  for (std::uint64_t i = 0; i < 5; ++i)
    path.push_back({0.3 * static_cast<double>(i), arbitrary(seed + i, 1.0),
                    arbitrary(seed + 100 + i, 1.8), 0.0});
  const Motion m = along(path);
  for (const PathPoint& row : path) {
    const Pose X_WB = pose_at(m, row.time);
    RC_ASSERT((X_WB.p - row.p_WB).norm() <= rounding);
    RC_ASSERT((X_WB.R - rotation::exp(row.rotation_WB)).norm() <= 10 * rounding);
  }
}

RC_GTEST_PROP(Motion, a_path_moves_the_bit_rigidly, (std::uint64_t seed)) {
  const Motion m = along({{0.0, arbitrary(seed, 1.0), arbitrary(seed + 1, 1.8), 0.0},
                          {1.0, arbitrary(seed + 2, 1.0), arbitrary(seed + 3, 1.8), 0.0}});
  for (const double t : {-1.0, 0.1, 0.37, 0.99, 2.0}) {
    const Mat3 R = pose_at(m, t).R;
    RC_ASSERT((R.transpose() * R - Mat3::Identity()).norm() <= 10 * rounding);
    RC_ASSERT(std::abs(R.determinant() - 1.0) <= 10 * rounding);
  }
}

/// Equal times turn the bit by equal rotations, and move its origin by equal steps.
RC_GTEST_PROP(Motion, a_path_turns_at_a_constant_rate_between_rows, (std::uint64_t seed)) {
  const Motion m = along({{0.0, arbitrary(seed, 1.0), arbitrary(seed + 1, 1.0), 0.0},
                          {1.0, arbitrary(seed + 2, 1.0), arbitrary(seed + 3, 1.0), 0.0}});
  const auto step = [&](double t) {
    return Mat3(pose_at(m, t).R.transpose() * pose_at(m, t + 0.2).R);
  };
  const Vec3 way = pose_at(m, 0.2).p - pose_at(m, 0.0).p;
  for (const double t : {0.1, 0.35, 0.8}) {
    RC_ASSERT((step(t) - step(0.0)).norm() <= 20 * rounding);
    RC_ASSERT((pose_at(m, t + 0.2).p - pose_at(m, t).p - way).norm() <= 10 * rounding);
  }
}

TEST(Motion, a_path_about_z_is_the_closed_form) {
  const Motion m = along({{0.0, Vec3::Zero(), Vec3::Zero(), 0.0},
                          {1.0, Vec3(0, 0, 1), Vec3(0, 0, 2.0), 0.0},
                          {2.0, Vec3(0, 0, 1), Vec3(0, 0, 4.0 - 2.0 * pi), 0.0}});
  EXPECT_LE((pose_at(m, 0.25).R - turn_about_z(0.5)).norm(), rounding);
  EXPECT_LE((pose_at(m, 1.5).R - turn_about_z(3.0)).norm(), 4 * rounding);
  EXPECT_NEAR(angle_turned(m, 0.25), 0.5, rounding);
  EXPECT_NEAR(angle_turned(m, 1.5), 3.0, 4 * rounding);  // wrapped rotation vectors add up
  EXPECT_NEAR(angle_turned(m, 2.0), 4.0, 4 * rounding);
}

TEST(Motion, a_path_rests_before_its_first_and_after_its_last_row) {
  const Motion m = along(
      {{1.0, Vec3(1, 2, 3), Vec3(0, 0, 0.1), 0.0}, {2.0, Vec3(4, 5, 6), Vec3(0, 0, 0.2), 0.0}});
  EXPECT_EQ(pose_at(m, 0.0).p, Vec3(1, 2, 3));
  EXPECT_EQ(pose_at(m, 9.0).p, Vec3(4, 5, 6));
  EXPECT_EQ(angle_turned(m, 0.0), 0.0);
  EXPECT_NEAR(angle_turned(m, 9.0), 0.1, rounding);
}

TEST(Motion, a_tilted_axis_leans_by_its_angle_towards_its_azimuth) {
  Motion m = steady();
  m.tilt = {0.1, 0.3, 5.0, WhirlSense::backward, 0.5};
  for (const double t : {0.0, 0.25, 0.5, 2.0}) {
    const Pose X_WB = pose_at(m, t);
    const double angle = 0.1 * std::min(1.0, t / 0.5), azimuth = 0.3 - 5.0 * t;
    const Vec3 axis(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                    std::cos(angle));
    EXPECT_LE((X_WB.R.col(2) - axis).norm(), rounding) << t;
    EXPECT_EQ(X_WB.p, pose_at(steady(), t).p);
  }
}

/// About its tilted axis the bit turns like an upright one: seen along the axis, x has turned by
/// the angle.
TEST(Motion, a_tilted_bit_turns_about_its_axis) {
  Motion m = steady();
  m.tilt = {0.2, 0.0, 0.0, WhirlSense::forward, 0.0};
  const Mat3 lean = pose_at(m, 0.0).R;
  for (const double t : {0.1, 0.7})
    EXPECT_LE((lean.transpose() * pose_at(m, t).R - turn_about_z(4.0 * pi * t)).norm(),
              100.0 * rounding);
}

/// No row turns farther than a quarter from the one before, and none is spare.
TEST(Motion, legs_have_a_row_for_every_quarter_turn) {
  const Vec3 down(0, 0, 0.004);
  EXPECT_EQ(path_of({{2.0, down, 4.0 * pi}}, Vec3::Zero()).size(), 1U + 16U);
  EXPECT_EQ(path_of({{1.0, down, -0.51 * pi}}, Vec3::Zero()).size(), 1U + 2U);
  EXPECT_EQ(path_of({{1.0, down, 0.49 * pi}, {1.0, down, 0.0}}, Vec3::Zero()).size(), 1U + 2U);
}

TEST(Motion, legs_are_the_closed_form) {
  const Vec3 start(0.1, 0.2, 0.3), down(0, 0, 0.004), aside(0.003, -0.001, 0);
  Motion m;
  m.kind = MotionKind::legs;
  m.path = path_of({{2.0, down, 4.0 * pi}, {0.5, aside, 0.0}, {1.0, -down, -2.0 * pi}}, start);
  const auto expect_at = [&](double t, const Vec3& p, double turned) {
    EXPECT_LE((pose_at(m, t).p - p).norm(), rounding) << t;
    EXPECT_LE((pose_at(m, t).R - turn_about_z(turned)).norm(), 100.0 * rounding) << t;
    EXPECT_NEAR(angle_turned(m, t), turned, 100.0 * rounding) << t;
  };
  expect_at(0.0, start, 0.0);
  expect_at(1.3, start + 1.3 * down, 5.2 * pi);
  expect_at(2.2, start + 2.0 * down + 0.2 * aside, 8.0 * pi);
  expect_at(3.1, start + 1.4 * down + 0.5 * aside, 6.8 * pi);
  expect_at(9.0, start + 1.0 * down + 0.5 * aside, 6.0 * pi);
}

/// How fast the bit goes along a path does not depend on where the path begins.
TEST(SpeedsOf, a_path_are_those_of_its_pieces_wherever_it_lies) {
  const Vec3 aside(70.0, -20.0, 300.0);
  for (const Vec3& from : {Vec3(Vec3::Zero()), aside}) {
    const Motion m = along({{0.0, from, Vec3::Zero()},
                            {2.0, from + Vec3(3.0, 0.0, 4.0), Vec3::Zero()},
                            {2.5, from + Vec3(3.0, 1.0, 4.0), Vec3(0.0, 0.0, 0.5)}});
    const std::vector<Speeds> speeds = speeds_of(m);
    ASSERT_EQ(speeds.size(), 2U);
    EXPECT_NEAR(speeds[0].shift, 2.5, 1e-13);
    EXPECT_NEAR(speeds[0].w_B.norm(), 0.0, 1e-15);
    EXPECT_NEAR(speeds[1].shift, 2.0, 1e-13);
    EXPECT_NEAR(speeds[1].w_B.z(), 1.0, 1e-14);
  }
}

}  // namespace tdbd::simulation::motion_test

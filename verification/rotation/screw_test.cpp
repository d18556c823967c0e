#include "rotation/screw.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/battery/generators.hpp"

namespace tdbd::rotation::screw_test {

using Mat4 = Eigen::Matrix4d;
constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-15;

/// Twin: the power series of exp of the 4 x 4 matrix of the twist times s, halved ten times and squared back.
Mat4 exp_by_series(const Twist& twist, double s) {
  constexpr int halvings = 10;
  Mat4 A = Mat4::Zero();
  A.topLeftCorner<3, 3>() = skew(twist.angular_B);
  A.topRightCorner<3, 1>() = twist.linear_B;
  A *= std::ldexp(s, -halvings);
  // exp(A) - 1, so that small turns keep their digits: (1 + E)^2 - 1 = 2 E + E^2.
  Mat4 term = A, E = A;
  for (int k = 2; k < 25; ++k) {
    term = term * A / k;
    E += term;
  }
  for (int k = 0; k < halvings; ++k) E = Mat4(2.0 * E + E * E);
  return Mat4::Identity() + E;
}

Mat4 matrix(const Pose& X) {
  Mat4 M = Mat4::Identity();
  M.topLeftCorner<3, 3>() = X.R;
  M.topRightCorner<3, 1>() = X.p;
  return M;
}

double distance(const Pose& X, const Mat4& M) { return (matrix(X) - M).cwiseAbs().maxCoeff(); }

/// Turns of 1e-12 to `most` in unit time, so that every branch is taken; velocities up to 2 m/s.
rc::Gen<Twist> twist(double most) {
  return rc::gen::apply(
      [most](const Vec3& axis, double share, int exponent, const Vec3& linear_B) {
        return Twist{most * share * std::pow(10.0, -exponent) * axis, linear_B};
      },
      battery::direction(), battery::number(0.1, 1.0), rc::gen::inRange(0, 12),
      battery::point(2.0));
}

Pose pose(const Vec3& turn, const Vec3& p) { return {exp(turn), p}; }

RC_GTEST_PROP(Screw, carried_is_the_exponential_of_the_twist, ()) {
  const Twist v = *twist(2.0 * pi);
  const double s = *battery::number(-1.0, 1.0);
  RC_ASSERT(distance(carried(v, s), exp_by_series(v, s)) < 200.0 * rounding);
}

TEST(Screw, both_branches_of_carried_agree_where_they_meet) {
  for (const double angle : {1e-5, 3.1e-4, 3.2e-4, 1e-3}) {  // the series ends at 3.16e-4
    const Twist v{angle * Vec3(0.6, 0.0, 0.8), Vec3(1.0, -2.0, 0.5)};
    EXPECT_LT(distance(carried(v, 1.0), exp_by_series(v, 1.0)), 5.0 * rounding) << angle;
  }
}

RC_GTEST_PROP(Screw, motions_of_one_twist_add_up, ()) {
  const Twist v = *twist(pi);
  const double s = *battery::number(-1.0, 1.0), t = *battery::number(-1.0, 1.0);
  RC_ASSERT(distance(carried(v, s) * carried(v, t), matrix(carried(v, s + t))) < 100.0 * rounding);
}

RC_GTEST_PROP(Screw, velocity_is_the_rate_of_the_motion, ()) {
  const Twist v = *twist(pi);
  const Vec3 x_B = *battery::point(1.0);
  constexpr double h = 1e-5;
  const Vec3 rate = (carried(v, h) * x_B - carried(v, -h) * x_B) / (2.0 * h);
  RC_ASSERT((rate - velocity_B(v, x_B)).norm() < 2e-9);
}

/// Wherever the bit stands: turns of up to 3 rad, as the function promises.
RC_GTEST_PROP(Screw, twist_from_gives_back_the_motion, ()) {
  const Twist v = *twist(3.0);
  const double dt = *battery::number(0.1, 1.0);
  const Pose X_WB0 = pose(*battery::point(2.0), *battery::point(2.0));
  const Twist motion{v.angular_B / dt, v.linear_B / dt};
  const Twist found = twist_from(X_WB0, X_WB0 * carried(motion, dt), dt);
  RC_ASSERT((found.angular_B - motion.angular_B).norm() * dt < 50.0 * rounding);
  RC_ASSERT((found.linear_B - motion.linear_B).norm() * dt < 200.0 * rounding);
}

TEST(Screw, both_branches_of_twist_from_agree_where_they_meet) {
  for (const double angle : {1e-6, 0.99e-3, 1.01e-3, 1e-2}) {  // the series ends at 1e-3
    const Twist v{angle * Vec3(0.6, 0.0, 0.8), Vec3(1.0, -2.0, 0.5)};
    const Twist found = twist_from(Pose{}, carried(v, 1.0), 1.0);
    EXPECT_LT((found.angular_B - v.angular_B).norm(), 5.0 * rounding) << angle;
    EXPECT_LT((found.linear_B - v.linear_B).norm(), 5e-14) << angle;
  }
}

TEST(Screw, translation_has_no_turn) {
  const Vec3 p(0.1, -0.2, 0.3);
  const Twist v = twist_from(Pose{}, {Mat3::Identity(), p}, 2.0);
  EXPECT_EQ(v.angular_B, Vec3(Vec3::Zero()));
  EXPECT_EQ(v.linear_B, Vec3(0.5 * p));
  EXPECT_EQ(carried(v, 2.0).p, p);
}

/// The twist of a small turn is found to the last digits: its series has two terms up to 1e-3.
TEST(Screw, twist_of_a_small_turn_is_found_to_rounding) {
  for (const double angle : {1e-6, 3e-4, 9e-4, 9.99e-4, 1.01e-3})
    for (const double x : {1.0, 0.3, -0.7}) {
      const Twist v{angle * Vec3::UnitZ(), Vec3(x, 0.5, 0.25)};
      const Twist found = twist_from(Pose{}, carried(v, 1.0), 1.0);
      EXPECT_LT((found.linear_B - v.linear_B).norm(), 0.6 * rounding) << angle;
    }
}

}  // namespace tdbd::rotation::screw_test

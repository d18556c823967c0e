#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rotation/quaternion.hpp"
#include "verification/battery/dual.hpp"

namespace tdbd::rotation::swing_twist_test {

using Jet3 = battery::Dual<3>;

constexpr double rounding = 1e-13;
constexpr double near_the_end = 4e-10;  // slope of f from a difference of nearly equal numbers

double between(int lo, int hi) { return 1e-4 * *rc::gen::inRange(10'000 * lo, 10'000 * hi); }

/// A swing about a horizontal axis after a twist about z.
struct Angles {
  Eigen::Vector2d swing;
  double twist;
};

Angles random_angles() {
  Angles a;
  const double size = between(0, 3), direction = between(-3, 3);
  a.swing = size * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  a.twist = between(-3, 3);
  return a;
}

Eigen::Quaterniond attitude(const Angles& a) {
  return quaternion_exp<double>(Eigen::Vector3d(a.swing.x(), a.swing.y(), 0.0)) *
         quaternion_exp<double>(Eigen::Vector3d(0.0, 0.0, a.twist));
}

RC_GTEST_PROP(SwingTwist, gives_back_the_swing_and_the_twist, ()) {
  const Angles a = random_angles();
  const Eigen::Quaterniond q = attitude(a);
  RC_ASSERT(std::abs(twist_angle(q, 0) - a.twist) <= rounding);
  RC_ASSERT((swing(q).b.head<2>() - a.swing).norm() <= 10.0 * rounding);
}

RC_GTEST_PROP(SwingTwist, gradient_is_the_derivative_of_the_twist, ()) {
  const Eigen::Quaterniond q = attitude(random_angles());
  Eigen::Matrix<Jet3, 3, 1> turn;
  for (int i = 0; i < 3; ++i) {
    turn[i] = Jet3(0.0);
    turn[i].by[i] = 1.0;
  }
  const Jet3 angle = twist_angle<Jet3>(quaternion_exp<Jet3>(turn) * q.cast<Jet3>(), 0);
  const Eigen::Vector3d gradient = twist_gradient(q);
  RC_ASSERT((angle.by.matrix() - gradient).norm() <= rounding * (1.0 + gradient.squaredNorm()));
}

TEST(SwingTwist, swings_almost_upside_down) {
  for (const double short_of : {1e-2, 1e-4, 1e-6}) {
    const double angle = std::numbers::pi - short_of;
    const auto q = quaternion_exp<double>(Eigen::Vector3d(0.6 * angle, 0.8 * angle, 0.0));
    EXPECT_NEAR(swing(q).b.norm(), angle, 1e3 * rounding) << short_of;  // sin(angle) is 1 / f
  }
}

TEST(SwingTwist, the_series_of_f_keeps_its_digits_to_its_end) {
  for (const double angle : {1e-4, 0.9999e-3}) {
    const auto q = quaternion_exp<double>(Eigen::Vector3d(angle, 0.0, 0.0));
    EXPECT_NEAR(swing(q).f, angle / std::sin(angle), 4e-16) << angle;
  }
}

/// What counts is where the path of q passes z = 0, not where it ends: here at w < 0.
TEST(SwingTwist, counts_a_winding_that_ends_at_w_above_zero) {
  const Eigen::Quaterniond from = Eigen::Quaterniond(-0.3, 0.95, 0.0, 0.05).normalized();
  const Eigen::Quaterniond to = Eigen::Quaterniond(0.1, 0.95, 0.0, -0.2).normalized();
  EXPECT_EQ(double_turns_between(from, to), 1);
  EXPECT_EQ(double_turns_between(to, from), -1);
}

TEST(SwingTwist, slope_of_f_is_continuous_where_its_series_ends) {
  const auto slope_at = [](double swing_angle) {
    return swing(quaternion_exp<double>(Eigen::Vector3d(swing_angle, 0.0, 0.0))).slope;
  };
  // wide: three roundings of 1 - f z over a squared sine of 1e-6
  EXPECT_NEAR(slope_at(0.9999e-3), slope_at(1.0001e-3), near_the_end);
  EXPECT_NEAR(slope_at(0.0), -1.0 / 3.0, rounding);
}

TEST(SwingTwist, counts_turns_forward_and_backward) {
  for (const double step : {0.7, -0.7}) {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    long turns = 0;
    for (int i = 0; i < 100; ++i) {
      const Eigen::Quaterniond next = q * quaternion_exp<double>(Eigen::Vector3d(0, 0, step));
      turns += double_turns_between(q, next);
      q = next;
    }
    EXPECT_NEAR(twist_angle(q, turns), 100.0 * step, 100.0 * rounding);
  }
}

}  // namespace tdbd::rotation::swing_twist_test

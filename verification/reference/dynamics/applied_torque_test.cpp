#include "reference/dynamics/applied_torque.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "battery/generators.hpp"

namespace tdbd::reference::applied_torque_test {

using Eigen::AngleAxisd;

Mat3 swing(double x, double y) {
  const double angle = std::hypot(x, y);
  const Vec3 axis = angle > 0.0 ? Vec3(Vec3(x, y, 0.0) / angle) : Vec3(Vec3::UnitX());
  return Mat3(AngleAxisd(angle, axis));
}

Mat3 twist(double z) { return Mat3(AngleAxisd(z, Vec3::UnitZ())); }

/// Rounding of angles up to 20 rad that come from a matrix.
constexpr double angle_rounding = 1e-13;

RC_GTEST_PROP(AppliedTorque, swing_and_twist_are_those_the_attitude_was_made_of, ()) {
  const double x = *battery::number(-2.0, 2.0), y = *battery::number(-2.0, 2.0);
  const double z = *battery::number(-20.0, 20.0);
  const double off = *battery::number(-3.0, 3.0);  // less than half a turn
  const SwingTwist a = swing_twist(swing(x, y) * twist(z), z + off);
  RC_ASSERT(std::abs(a.swing_x_W - x) < angle_rounding);
  RC_ASSERT(std::abs(a.swing_y_W - y) < angle_rounding);
  RC_ASSERT(std::abs(a.twist - z) < angle_rounding);
}

/// A swing of at most 2 rad, so that no derivative of order 9 is large.
constexpr double gradient_error = 1e-12;  // of the energy + stiffness

/// The closed form for equal swing stiffnesses: the swing's torque is -k a about the swing's axis
/// plus what the twist gives: the twist's rate is w . (ez + n) / (1 + n_z).
RC_GTEST_PROP(AppliedTorque, spring_torque_is_the_closed_form_for_equal_swing_stiffnesses, ()) {
  const double x = *battery::number(-1.4, 1.4), y = *battery::number(-1.4, 1.4);
  const double z = *battery::number(-10.0, 10.0);
  const double k = *battery::number(0.0, 5.0), kz = *battery::number(0.0, 5.0);
  const Mat3 R_WB = swing(x, y) * twist(z);
  const Vec3 n_W = R_WB.col(2);
  const Vec3 expected_W = -k * Vec3(x, y, 0.0) - kz * z * (Vec3::UnitZ() + n_W) / (1.0 + n_W.z());
  const double energy = 0.5 * (k * (x * x + y * y) + kz * z * z);
  const Vec3 torque_W = spring_torque({k, k, kz}, R_WB, z);
  RC_ASSERT((torque_W - expected_W).norm() < gradient_error * (1.0 + k + kz + energy));
}

TEST(AppliedTorque, each_spring_pulls_back_about_its_own_axis) {
  const Vec3 k(3.0, 5.0, 7.0);
  EXPECT_LE((spring_torque(k, swing(0.4, 0.0), 0.0) - Vec3(-1.2, 0, 0)).norm(), 1e-12);
  EXPECT_LE((spring_torque(k, swing(0.0, 0.4), 0.0) - Vec3(0, -2.0, 0)).norm(), 1e-12);
  EXPECT_LE((spring_torque(k, twist(9.0), 9.0) - Vec3(0, 0, -63.0)).norm(), 3.4e-12);
  EXPECT_LE(spring_torque(k, Mat3::Identity(), 0.0).norm(), 1e-13);
}

/// A swing vector counts in space whatever the twist.
TEST(AppliedTorque, unequal_springs_act_on_space_axes) {
  const Vec3 k(3.0, 5.0, 0.0);
  const Vec3 torque_W = spring_torque(k, swing(0.4, 0.0) * twist(1.0), 1.0);
  EXPECT_LE((torque_W - Vec3(-1.2, 0, 0)).norm(), 1e-12);
}

TEST(AppliedTorque, samples_are_joined_by_lines_and_held_outside) {
  const dynamics::SampledTorque s{
      dynamics::TorqueFrame::body, {1.0, 2.0, 4.0}, {Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(-1, 2, 0)}};
  EXPECT_EQ(sampled_torque(s, 0.0), Vec3(1, 0, 0));
  EXPECT_EQ(sampled_torque(s, 1.5), Vec3(2, 0, 0));
  EXPECT_EQ(sampled_torque(s, 2.0), Vec3(3, 0, 0));
  EXPECT_EQ(sampled_torque(s, 3.0), Vec3(1, 1, 0));
  EXPECT_EQ(sampled_torque(s, 9.0), Vec3(-1, 2, 0));
  EXPECT_EQ(sampled_torque({}, 9.0), Vec3(0, 0, 0));
}

/// Each load alone, at an attitude that turns x to y to z to x.
TEST(AppliedTorque, each_load_acts_in_its_own_frame) {
  Mat3 R_WB;
  R_WB << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // R ex = ey, R ey = ez, R ez = ex
  const auto torque_B = [&](const dynamics::Loads& l) {
    return applied_torque(l, 0.5, R_WB, Vec3(1, 2, 3), 0.0);
  };
  dynamics::Loads l;
  l.body_torque_B = Vec3(1, 2, 3);
  EXPECT_EQ(torque_B(l), Vec3(1, 2, 3));
  l = {};
  l.space_torque_W = Vec3(1, 2, 3);
  EXPECT_EQ(torque_B(l), Vec3(2, 3, 1));
  l = {};
  l.gravity_moment = 2.0;  // the force -2 ez is -2 ey in the bit; the arm ex: a moment -2 ez
  l.gravity_arm_B = Vec3::UnitX();
  EXPECT_EQ(torque_B(l), Vec3(0, 0, -2));
  l = {};
  l.damping_W = Vec3(1, 10, 100);  // w_W = (3, 1, 2)
  EXPECT_EQ(torque_B(l), Vec3(-10, -200, -3));
  l = {};
  l.harmonics = {{dynamics::TorqueFrame::space, Vec3(1, 0, 0), 2.0, 0.25},
                 {dynamics::TorqueFrame::body, Vec3(1, 0, 0), 4.0, 0.0}};
  EXPECT_LE((torque_B(l) - Vec3(std::cos(2.0), 0, std::cos(1.25))).norm(), 1e-15);
  l = {};
  l.samples = {{dynamics::TorqueFrame::space, {0.0, 1.0}, {Vec3(0, 0, 0), Vec3(4, 0, 0)}},
               {dynamics::TorqueFrame::body, {0.0, 1.0}, {Vec3(0, 0, 0), Vec3(8, 0, 0)}}};
  EXPECT_EQ(torque_B(l), Vec3(4, 0, 2));
}

}  // namespace tdbd::reference::applied_torque_test

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/generators.hpp"
#include "core/error.hpp"
#include "dynamics/momenta.hpp"
#include "dynamics/rotation/step.hpp"
#include "reference/dynamics/applied_torque.hpp"
#include "reference/dynamics/ode.hpp"
#include "reference/dynamics/runge_kutta.hpp"

/// The program's torques against the twin's, loads of every kind at once.
namespace tdbd::reference::program_torque_test {

using dynamics::TorqueFrame;

/// The twin differences the potential: good to 1e-12 of the largest energy.
constexpr double torque_agreement = 1e-12;  // of 1 + energies and torques
constexpr double energy_agreement = 1e-12;  // of 1 + energies

rc::Gen<Vec3> not_negative(double largest) {
  return rc::gen::apply([](double x, double y, double z) { return Vec3(x, y, z); },
                        battery::number(0.0, largest), battery::number(0.0, largest),
                        battery::number(0.0, largest));
}

dynamics::Loads any_loads(std::size_t cones) {
  dynamics::Loads l;
  l.body_torque_B = *battery::point(2.0);
  l.space_torque_W = *battery::point(2.0);
  l.gravity_moment = *battery::number(-5.0, 5.0);
  l.gravity_arm_B = *battery::direction();
  for (const TorqueFrame frame : {TorqueFrame::body, TorqueFrame::space}) {
    l.harmonics.push_back(
        {frame, *battery::point(2.0), *battery::number(0.0, 9.0), *battery::number(-3.0, 3.0)});
    l.samples.push_back({frame,
                         {0.1, 0.4, 0.5},
                         {*battery::point(2.0), *battery::point(2.0), *battery::point(2.0)}});
  }
  l.stiffness_W = *not_negative(4.0);
  l.damping_W = *not_negative(1.0);
  for (std::size_t k = 0; k < cones; ++k)
    l.cones.push_back(
        {*battery::number(-0.5, 0.5), *battery::number(-0.5, 0.5), *battery::number(0.0, 0.1)});
  return l;
}

dynamics::Gyrostat some_bit() {
  return dynamics::make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(),
                                 {{Vec3(0.8, 0, 0.6), 0.1}, {Vec3(-0.6, 0.5, 0.6), 0.2}});
}

/// Away from half a turn of swing, where no angle is defined.
dynamics::RotationState any_state(const dynamics::Gyrostat& g) {
  const double z = *battery::number(-3.0, 3.0);
  const Vec3 swing(*battery::number(-1.4, 1.4), *battery::number(-1.4, 1.4), 0.0);
  const Mat3 R_WB = Eigen::AngleAxisd(swing.norm(), swing.normalized()).toRotationMatrix() *
                    Eigen::AngleAxisd(z, Vec3::UnitZ()).toRotationMatrix();
  const std::vector<double> spins{*battery::number(-9.0, 9.0), *battery::number(-9.0, 9.0)};
  auto s = dynamics::make_state(g, R_WB, *battery::point(4.0), spins, std::vector<double>(2, 0.0));
  s.turns = *battery::integer(-2, 2);
  s.time = *battery::number(0.0, 1.0);
  return s;
}

RC_GTEST_PROP(ProgramTorque, is_the_twins, ()) {
  const dynamics::Gyrostat g = some_bit();
  const dynamics::Loads loads = any_loads(g.cones.size());
  const dynamics::RotationState s = any_state(g);
  const GyrostatState twin = matrix_state(s);
  const double potential = total_energy(g, loads, twin) - total_energy(g, {}, twin);
  const double scale =
      1.0 + std::abs(potential) + spring_energy(loads.stiffness_W, twin.R_WB, twin.twist);
  dynamics::Torque t;
  dynamics::evaluate(g, loads, s, t);
  const Vec3 w_B = bit_angular_velocity(g, twin);
  Vec3 total_B = applied_torque(loads, s.time, twin.R_WB, w_B, twin.twist);
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const dynamics::ConeLoad& load = loads.cones[k];
    const Vec3& axis_B = g.cones[k].axis_B;
    const double spin = s.cone_momenta[k] / g.cones[k].axial_inertia - axis_B.dot(w_B);
    total_B += load.external * axis_B;
    RC_ASSERT(std::abs(t.cones[k] - (load.internal + load.external - load.damping * spin)) <
              energy_agreement * scale);
  }
  RC_ASSERT((t.total_W - twin.R_WB * total_B).norm() < torque_agreement * scale);
  RC_ASSERT(std::abs(dynamics::potential_energy(loads, s) - potential) < energy_agreement * scale);
}

/// A whole motion that does not swing near half a turn, where the twist's rate is singular and the
/// twin's error grows without bound, under loads of every kind but samples, whose corners no high
/// order likes: the eighth-order composition at a step at which its own error is below rounding's.
RC_GTEST_PROP(ProgramTorque, moves_the_bit_as_the_twin_does, ()) {
  constexpr double h = 1.0 / 256.0, agreement = 1.5e-11;  // of 1 + momentum, angles in rad
  const dynamics::Gyrostat g = some_bit();
  dynamics::Loads loads = any_loads(g.cones.size());
  loads.samples.clear();
  dynamics::RotationState s = any_state(g);
  s.time = 0.0;
  const GyrostatState expected = runge_kutta(g, loads, matrix_state(s), 0.25).state;
  const dynamics::Integrator integrator{dynamics::Drift::split, 1, 8,
                                        dynamics::VelocityTorque::symmetric};
  dynamics::Rotating r = dynamics::start(g, loads, s);
  double lowest = 1.0;  // cosine of the swing
  for (int i = 0; i < 64; ++i) {
    dynamics::step(g, loads, integrator, h, r);
    lowest = std::min(lowest, matrix_state(r.state).R_WB(2, 2));
  }
  RC_PRE(lowest > -0.8);
  const GyrostatState end = matrix_state(r.state);
  double difference =
      (end.R_WB - expected.R_WB).norm() + (end.body_momentum_B - expected.body_momentum_B).norm();
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    difference += std::abs(end.cone_angles[k] - expected.cone_angles[k]) +
                  std::abs(end.cone_momenta[k] - expected.cone_momenta[k]);
  RC_ASSERT(difference < agreement * (1.0 + expected.body_momentum_B.norm()));
}

/// x'' = -x, as (x, x').
const RightHandSide oscillator = [](double, std::span<const double> y, std::span<double> dydt) {
  dydt[0] = y[1];
  dydt[1] = -y[0];
};

double oscillator_error(const std::vector<double>& y, double t) {
  return std::hypot(y[0] - std::cos(t), y[1] + std::sin(t));
}

/// Five thousand steps of equal length: the clock must not lose their rounding, 1e-12 s.
TEST(Ode, rounding_tolerance_reaches_rounding_and_keeps_the_time) {
  std::vector<double> y{1.0, 0.0};
  const long evaluations = integrate(oscillator, OdeMethod::rk8pd, {}, 0.0, 500.0, y);
  EXPECT_LE(oscillator_error(y, 500.0), 2e-13);  // 500 rad at 1e-16, with some room
  EXPECT_GT(evaluations, 20000);
}

TEST(Ode, counts_every_evaluation) {
  long called = 0;
  const RightHandSide counting = [&](double t, std::span<const double> y, std::span<double> dydt) {
    ++called;
    oscillator(t, y, dydt);
  };
  for (const OdeMethod method : {OdeMethod::rk8pd, OdeMethod::rkf45}) {
    called = 0;
    std::vector<double> y{1.0, 0.0};
    EXPECT_EQ(integrate(counting, method, {1e-8, 1e-8}, 0.0, 10.0, y), called);
  }
  called = 0;
  std::vector<double> y{1.0, 0.0};
  EXPECT_EQ(integrate_rk4(counting, 50, 0.0, 10.0, y), 200);
  EXPECT_EQ(called, 200);
}

TEST(Ode, a_wider_tolerance_needs_fewer_evaluations_and_has_a_larger_error) {
  std::vector<double> loose{1.0, 0.0}, tight{1.0, 0.0};
  const long few = integrate(oscillator, OdeMethod::rkf45, {1e-4, 1e-4}, 0.0, 10.0, loose);
  const long many = integrate(oscillator, OdeMethod::rkf45, {1e-10, 1e-10}, 0.0, 10.0, tight);
  EXPECT_LT(5 * few, many);
  EXPECT_GT(oscillator_error(loose, 10.0), 1000.0 * oscillator_error(tight, 10.0));
}

TEST(Ode, rk4_is_of_order_4) {
  std::vector<double> errors;
  for (const int steps : {100, 200}) {
    std::vector<double> y{1.0, 0.0};
    integrate_rk4(oscillator, steps, 0.0, 10.0, y);
    errors.push_back(oscillator_error(y, 10.0));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, 3.2e-4);
}

/// y' = 3 t^2 from t = 1: every method must see the absolute time.
TEST(Ode, equations_see_the_time) {
  const RightHandSide cube = [](double t, std::span<const double>, std::span<double> dydt) {
    dydt[0] = 3.0 * t * t;
  };
  for (const OdeMethod method : {OdeMethod::rk8pd, OdeMethod::rkf45}) {
    std::vector<double> y{1.0};
    integrate(cube, method, {1e-12, 1e-12}, 1.0, 2.0, y);
    EXPECT_NEAR(y[0], 8.0, 1e-12);
  }
  std::vector<double> y{1.0};
  integrate_rk4(cube, 10, 1.0, 2.0, y);
  EXPECT_NEAR(y[0], 8.0, 1e-13);
}

/// y' = y^2, y(0) = 1 ends at t = 1.
TEST(Ode, a_singularity_is_an_error) {
  const RightHandSide explosion = [](double, std::span<const double> y, std::span<double> dydt) {
    dydt[0] = y[0] * y[0];
  };
  std::vector<double> y{1.0};
  EXPECT_THROW(integrate(explosion, OdeMethod::rk8pd, {}, 0.0, 2.0, y), RunError);
}

}  // namespace tdbd::reference::program_torque_test

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
  EXPECT_EQ(reference::sampled_torque(s, 0.0), Vec3(1, 0, 0));
  EXPECT_EQ(reference::sampled_torque(s, 1.5), Vec3(2, 0, 0));
  EXPECT_EQ(reference::sampled_torque(s, 2.0), Vec3(3, 0, 0));
  EXPECT_EQ(reference::sampled_torque(s, 3.0), Vec3(1, 1, 0));
  EXPECT_EQ(reference::sampled_torque(s, 9.0), Vec3(-1, 2, 0));
  EXPECT_EQ(reference::sampled_torque({}, 9.0), Vec3(0, 0, 0));
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

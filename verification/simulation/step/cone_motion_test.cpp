#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "rotation/screw.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/bit/cone_generate.hpp"
#include "verification/simulation/wheel_bit.hpp"

namespace tdbd::simulation::cone_motion_test {

using bit::number;

Case wheel_case(const std::string& motion, const std::string& time) {
  return read_case(write_wheel_case(test_folder(), {}, motion, time), {});
}

Simulation drilled(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s;
}

Vec3 any_vector(double size) {
  return {number(-size, size), number(-size, size), number(-size, size)};
}

/// Turned about the unit axis by Rodrigues' formula: a chain of its own.
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * axis.cross(v) +
         (1 - std::cos(angle)) * axis.dot(v) * axis;
}

/// Thesis 5.1: p = c + R (r0 + S s + D Rot(s, phi) d0), at both ends of a step.
RC_GTEST_PROP(ConeMotion, a_motion_of_the_bit_reaches_each_tooth_through_its_cone, ()) {
  const bit::Bit b =
      bit::cone_bit("any", {bit::toothed_cone(), bit::toothed_cone()}, std::nullopt, {});
  const std::vector<double> from{number(-9, 9), number(-9, 9)}, to{number(-9, 9), number(-9, 9)};
  rock::CuttingBit cutting = rock::prepare_cutting_bit(b);
  rock::turn_cones(cutting, b, from, to);
  const Vec3 c_W = any_vector(1.0), axis = any_vector(1.0).normalized(), x_P = any_vector(0.01);
  const double angle = number(-3, 3);
  const Pose X_WB{Eigen::AngleAxisd(angle, axis).toRotationMatrix(), c_W};
  double farthest = 0.0;
  for (const rock::CuttingGroup& g : cutting.groups) {
    const bit::Part& part = b.parts[static_cast<std::size_t>(g.parts.front().part)];
    const auto k = static_cast<std::size_t>(part.cone);
    const Vec3 r0 = b.cones[k].X_BK.p, s = b.cones[k].X_BK.R.col(2);
    const Vec3 offset = part.X_BP * x_P - r0, S = s.dot(offset) * s, d0 = offset - S;
    const auto place = [&](double phi) {
      return Vec3(c_W + turned(r0 + S + turned(d0, s, phi), axis, angle));
    };
    farthest = std::max({farthest, (X_WB * (g.X_BP * x_P) - place(from[k])).norm(),
                         (X_WB * (g.X_BP1 * x_P) - place(to[k])).norm()});
  }
  RC_ASSERT(farthest < 1e-13);
}

/// Between any two poses, to rounding.
RC_GTEST_PROP(ConeMotion, a_twist_moves_points_like_the_poses, ()) {
  const Vec3 turn = any_vector(0.1), x_B = any_vector(0.1), about = any_vector(2.0);
  const Pose X_WB0{rotation::exp(about), any_vector(1.0)},
      X_WB1{X_WB0.R * rotation::exp(turn), X_WB0.p + any_vector(0.05)};
  const double dt = number(0.001, 0.01);
  const Pose X_BB1 = rotation::carried(rotation::twist_from(X_WB0, X_WB1, dt), dt);
  RC_ASSERT((X_WB0 * (X_BB1 * x_B) - X_WB1 * x_B).norm() < 1e-14);
}

/// A tooth of this cone that removed rock, where its tip is; nothing else is one.
RC_GTEST_PROP(ConeMotion, has_the_contacts_of_the_teeth_of_one_cone, ()) {
  const bit::Bit b =
      bit::cone_bit("any", {bit::toothed_cone(), bit::toothed_cone()}, std::nullopt, {});
  const std::vector<double> angles{number(-9, 9), number(-9, 9)};
  rock::CutReport cut;
  for (std::size_t i = 0; i < b.parts.size(); ++i)
    cut.removed_by_part.push_back(*rc::gen::inRange(0, 3) > 0 ? 1e-9 * number(1, 9) : 0.0);
  // A report may end early, and what once stood behind its end is no part of it.
  const auto told = *rc::gen::inRange<std::size_t>(0, b.parts.size());
  cut.removed_by_part.resize(told);
  for (const int cone : {0, 1}) {
    std::vector<bit::ConeContact> expected;
    for (std::size_t i = 0; i < told; ++i)
      if (b.parts[i].kind == bit::PartKind::tooth && b.parts[i].cone == cone &&
          cut.removed_by_part[i] > 0.0)
        expected.push_back({bit::turned(b, angles).parts[i].X_BP * bit::tooth_tip_P(b.parts[i]),
                            cut.removed_by_part[i]});
    const auto found = contacts_of(b, cone, angles, cut);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      RC_ASSERT((found[k].x_B - expected[k].x_B).norm() < 1e-15);
      RC_ASSERT(found[k].weight == expected[k].weight);
    }
  }
}

/// Exact for a screw motion.
RC_GTEST_PROP(ConeMotion, finds_the_twist_of_a_step, ()) {
  const double w = number(-20, 20), v = number(-0.1, 0.1), dt = number(1e-3, 0.02);
  Motion m;
  m.rotary_speed = w;
  m.rate_of_penetration = v;
  const double t = number(0, 10);
  const rotation::Twist twist = rotation::twist_from(pose_at(m, t), pose_at(m, t + dt), dt);
  RC_ASSERT((twist.angular_B - Vec3(0, 0, w)).norm() * dt < 1e-14 * (1 + std::abs(w) * t));
  RC_ASSERT((twist.linear_B - Vec3(0, 0, v)).norm() * dt < 1e-14);
}

/// Each turns against its Z by its speed over the bit's.
TEST(ConeMotion, cones_of_given_speeds_have_each_its_own) {
  Case c;
  c.bit.cones.resize(3);
  c.time.step = 1e-3;
  c.motion.rotary_speed = 5.0;
  c.motion.cones.speeds = {1.25, 1.5, 0.75};
  std::vector<ConeState> cones = start_cones(c);
  for (long done = 0; done < 3; ++done) turn_cones(c, done, {}, cones);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(cones[k].speed, -c.motion.cones.speeds[k] * 5.0, 1e-12) << k;
    EXPECT_NEAR(cones[k].angle, -c.motion.cones.speeds[k] * 5.0 * 3e-3, 1e-16) << k;
  }
}

TEST(ConeMotion, a_cone_without_contact_rolls_purely_and_keeps_its_speed) {
  Case c = wheel_case(wheel_motion, "step = 0.005\nduration = 0.1");
  std::vector<ConeState> cones = start_cones(c);
  const double w = c.motion.rotary_speed;
  rock::CutReport none, one;
  turn_cones(c, 0, none, cones);
  EXPECT_NEAR(cones[0].speed, -Wheel{}.ratio() * w, 1e-12 * w);
  one.removed_by_part.assign(c.bit.parts.size(), 0.0);
  one.removed_by_part[5] = 1e-9;  // a tooth off the lowest place
  turn_cones(c, 1, one, cones);
  const double after = cones[0].speed;
  EXPECT_GT(std::abs(after + Wheel{}.ratio() * w), 1e-3 * w);
  c.motion.cones.memory = 0.0;
  turn_cones(c, 2, one, cones);
  const double at_once = cones[0].speed;
  for (long k = 3; k < 5000; ++k) turn_cones(c, k, none, cones);
  EXPECT_EQ(cones[0].speed, at_once);
}

/// Without memory the torque of the last step's contacts vanishes at every step.
TEST(ConeMotion, no_torque_is_left_at_any_step) {
  const Case c = wheel_case(wheel_motion + "cone_memory = 0\n", "step = 0.005\nduration = 0.6");
  Simulation s = start(c);
  int balanced = 0;
  while (s.state.steps_done < c.time.steps) {
    const auto contacts = contacts_of(c.bit, 0, middle_angles(s.state.cones, 0.005), s.state.cut);
    step(c, s);
    double torque = 0.0, scale = 0.0;
    const Vec3 axis = c.bit.cones[0].X_BK.R.col(2), origin = c.bit.cones[0].X_BK.p;
    for (const bit::ConeContact& at : contacts) {
      const Vec3 r = at.x_B - origin, of_bit = Vec3(0, 0, c.motion.rotary_speed).cross(at.x_B) +
                                               Vec3(0, 0, c.motion.rate_of_penetration);
      const Vec3 force = -at.weight * (of_bit + s.state.cones[0].speed * axis.cross(r));
      torque += axis.dot(r.cross(force));
      scale += at.weight * r.norm() * of_bit.norm();
    }
    EXPECT_LE(std::abs(torque), 1e-11 * scale) << s.state.steps_done;
    balanced += contacts.empty() ? 0 : 1;
  }
  EXPECT_GT(balanced, 50);
}

ConeSummary wheel_figures(const Case& c) {
  const Simulation s = drilled(c);
  return summarize(c.bit.cones[0], s.state.cones[0], s.statistics.cones[0]);
}

/// Slip of a toothed wheel on a flat bottom that advances by `advance` (m) over a revolution.
double wheel_slip(double advance) {
  const Case c = wheel_case(
      "rotary_speed = \"60 rpm\"\nrate_of_penetration = " + std::to_string(advance) + "\n",
      "step = 0.005\nrevolutions = 1.5");
  const ConeSummary f = wheel_figures(c);
  EXPECT_NEAR(f.rolling_ratio_gage_row, Wheel{}.ratio(), 1e-14);
  EXPECT_NEAR(f.net_slip_gage_row, 1.0 - f.mean_speed_ratio / Wheel{}.ratio(), 1e-15);
  return f.net_slip_gage_row;
}

/// Exactly R/rho in the limit: teeth cut at psi before their lowest place, and what the wheel lags,
/// 1 - cos psi, is proportional to the advance.
TEST(ConeMotion, a_wheel_rolls_at_R_over_rho) {
  const double slip = wheel_slip(1.5e-3), half = wheel_slip(0.75e-3);
  EXPECT_GT(half, 0.0);
  EXPECT_LT(slip, 0.5 * 1.5e-3 / Wheel{}.rho);  // a third of psi of the whole depth
  EXPECT_NEAR(2.0 * half - slip, 0.0, 2e-4);
}

/// Of the steps in which the bit turned; rolling is positive.
TEST(ConeMotion, has_the_extremes_of_single_steps) {
  std::vector<ConeState> cones(1);
  std::vector<ConeStatistics> statistics(1);
  const auto turn = [&](double bit, double cone) {
    cones[0].turned = cone;
    add(bit, cones, statistics);
  };
  turn(0.1, -0.15);
  EXPECT_DOUBLE_EQ(statistics[0].least, 1.5);
  EXPECT_DOUBLE_EQ(statistics[0].greatest, 1.5);
  turn(0.1, -0.12);
  turn(0.0, -0.3);
  turn(0.1, -0.17);
  turn(0.1, -0.16);
  EXPECT_DOUBLE_EQ(statistics[0].least, 1.2);
  EXPECT_DOUBLE_EQ(statistics[0].greatest, 1.7);
  EXPECT_EQ(statistics[0].ratio.count, 4);
  EXPECT_DOUBLE_EQ(statistics[0].bit_turned, 0.4);
}

double mean_ratio(const std::string& step) {
  const Case c = wheel_case(wheel_motion, "step = " + step + "\nrevolutions = 1.5");
  return wheel_figures(c).mean_speed_ratio;
}

/// Halving the step, the mean speed converges with order 2: contacts count where they were in the
/// middle of their step.
TEST(ConeMotion, the_mean_speed_does_not_depend_on_the_step) {
  const double coarse = mean_ratio("0.01"), middle = mean_ratio("0.005"),
               fine = mean_ratio("0.0025");
  EXPECT_LT(std::abs(fine - middle), 9e-4);
  const double order = std::log2(std::abs(middle - coarse) / std::abs(fine - middle));
  EXPECT_GT(order, 1.5) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_LT(order, 2.5) << coarse << ' ' << middle << ' ' << fine;
}

}  // namespace tdbd::simulation::cone_motion_test

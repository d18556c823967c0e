#include "dynamics/drilling/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rotation/swing_twist.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::stability_test {

/// Springs at the slopes that the limit was computed for.
LumpedLaw linear_law(const ContactSlopes& c) {
  return [c](const DrillingSystem&, const DrillingState& x, const DrillingVelocity& v, Wrench& w) {
    w.force_W =
        -Vec3(c.lateral_stiffness * x.c_W.x() + c.lateral_damping * v.v_W.x(),
              c.lateral_stiffness * x.c_W.y() + c.lateral_damping * v.v_W.y(),
              c.axial_stiffness * (x.c_W.z() - x.rock_z) + c.axial_damping * (v.v_W.z() - v.rock));
    const double twist = rotation::twist_angle(x.rotation.q_WB, x.rotation.turns);
    w.torque_W.z() = -c.twist_stiffness * twist - c.twist_damping * v.w_W.z();
    w.rock_force = -w.force_W.z();
  };
}

/// Kinetic energy after many steps, over that of the start.
double growth(const DrillingSystem& s, const ContactSlopes& c, double h) {
  DrillingState from = at_rest(s);
  from.momentum_W = 1e-6 * Vec3(1.0, 1.0, 1.0);
  from.rotation.momentum_W = 1e-8 * Vec3(1.0, 1.0, 1.0);
  const LumpedLaw law = linear_law(c);
  DrillingRun d = start(s, law, from);
  for (int i = 0; i < 600; ++i) step(s, law, h, d);
  return std::sqrt(total(stored_energy(s, d.work.at, d.state)) / d.ledger.start);
}

DrillingSystem held_bit() {
  DrillingSystem s = plain_bit();
  s.centre_B = Vec3(0.01, 0.0, -0.05);
  s.gyrostat = make_gyrostat(Vec3(8.0, 7.0, 3.0).asDiagonal(), {{Vec3(0.6, 0.0, 0.8), 0.1}});
  s.string.stiffness.diagonal() = Vec3(7e5, 7e5, 7e5);
  s.string.attachment_B = Vec3(0.0, 0.0, -0.5);
  s.string.turn_stiffness.diagonal() = Vec3(4e4, 4e4, 938.0);
  s.rock = {280.0, 1e6, 0.0};
  return s;
}

/// 2 % below the limit nothing grows, 2 % above it something does: whatever vibrates fastest.
TEST(Stability, limit_is_sharp) {
  const ContactSlopes along{.axial_stiffness = 8.6e6}, across{.lateral_stiffness = 4e7},
      about{.twist_stiffness = 4e5};
  for (const ContactSlopes& c : {along, across, about}) {
    DrillingSystem s = held_bit();
    s.string.rest_W = s.string.attachment_B - s.centre_B;
    s = make_drilling_system(s);
    const double limit = stability_limit(s, c).step;
    EXPECT_LT(growth(s, c, 0.98 * limit), 2.9);
    EXPECT_GT(growth(s, c, 1.02 * limit), 1e6);
    EXPECT_EQ(stability_problem(s, c, 0.98 * limit), "");
    EXPECT_NE(stability_problem(s, c, 1.02 * limit), "");
  }
}

/// The string's own springs, held half a metre off the centre: they tilt the bit as they push it.
TEST(Stability, limit_of_the_string_is_sharp) {
  DrillingSystem s = held_bit();
  s.string.stiffness *= 1e3;
  s.string.rest_W = s.string.attachment_B - s.centre_B;
  s = make_drilling_system(s);
  const double limit = stability_limit(s, {}).step;
  EXPECT_LT(growth(s, {}, 0.98 * limit), 3.3);
  EXPECT_GT(growth(s, {}, 1.02 * limit), 1e6);
}

/// A ring below the centre that stays on its wall.
TEST(Stability, limit_of_the_wall_is_sharp) {
  DrillingSystem s = plain_bit();
  s.wall.stiffness = 1e9;
  s.wall.ring_z_B = 0.2;
  s = make_drilling_system(s);
  const double limit = stability_limit(s, {}).step;
  EXPECT_LT(growth(s, {}, 0.98 * limit), 7.0);
  EXPECT_GT(growth(s, {}, 1.02 * limit), 1e6);
}

/// A law that resists by velocity: h times slope over mass below 1.
TEST(Stability, limit_of_a_law_of_velocity_is_sharp) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  const ContactSlopes along{.axial_damping = 5e5}, about{.twist_damping = 2e3};
  for (const ContactSlopes& c : {along, about}) {
    const double limit = stability_limit(s, c).step;
    EXPECT_NEAR(limit, 1e-3, 1e-15);
    EXPECT_LT(growth(s, c, 0.98 * limit), 1.0);
    EXPECT_GT(growth(s, c, 1.02 * limit), 1e3);
  }
}

/// The limit is that of the spring without dampers. Weak ones do not change it; one that lets the
/// bit only creep, h D/M = 4000, slows the growth beyond it.
TEST(Stability, dampers_of_the_string_do_not_shorten_the_step) {
  constexpr double weak = 1e5;
  for (const double damping : {0.0, 1e3, weak, 1e9}) {
    DrillingSystem s = plain_bit();
    s.string.stiffness = (5e8 * Mat3::Identity()).eval();  // 1000 rad/s
    s.string.damping = (damping * Mat3::Identity()).eval();
    s = make_drilling_system(s);
    EXPECT_NEAR(stability_limit(s, {}).step, 2e-3, 1e-12);
    EXPECT_LT(growth(s, {}, 1.99e-3), 18.0) << damping;
    if (damping <= weak) {
      EXPECT_GT(growth(s, {}, 2.05e-3), 1e3) << damping;
    }
  }
}

/// However light: any mass above 0 is one that moves.
TEST(Stability, light_rock_swings_on_its_spring) {
  DrillingSystem s = plain_bit();
  s.rock.mass = 0.25;
  s.rock.stiffness = 1e6;  // 2000 rad/s
  const StabilityLimit limit = stability_limit(make_drilling_system(s), {});
  EXPECT_NEAR(limit.step, 1e-3, 1e-15);
  EXPECT_EQ(limit.mode, "the rock along z");
}

TEST(Stability, problem_says_the_limit_and_the_step_that_would_do) {
  DrillingSystem s = plain_bit();
  s.string.stiffness = (5e8 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  EXPECT_EQ(stability_problem(s, {}, 1e-3), "");
  EXPECT_EQ(stability_problem(s, {.axial_stiffness = 5e8}, 3e-3),
            "a step of 0.003 s is unstable: its fastest vibration (along z) has 1414 rad/s, and h "
            "omega must stay below 2; the limit is 0.001414 s, 0.0011 s would do");
  EXPECT_EQ(stability_problem(s, {.twist_damping = 2e4}, 1e-3),
            "a step of 0.001 s is unstable: the force law slows the bit at 1e+04 1/s, and h times "
            "that must stay below 1; the limit is 0.0001 s, 8e-05 s would do");
}

TEST(Stability, nothing_limits_a_free_bit) {
  const StabilityLimit limit = stability_limit(make_drilling_system(plain_bit()), {});
  EXPECT_EQ(limit.step, INFINITY);
  EXPECT_EQ(limit.frequency, 0.0);
  EXPECT_EQ(limit.rate, 0.0);
  EXPECT_EQ(limit.mode, StabilityLimit{}.mode);
  EXPECT_EQ(stability_problem(make_drilling_system(plain_bit()), {}, 1e9), "");
}

}  // namespace tdbd::dynamics::stability_test

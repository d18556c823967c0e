#include "reference/dynamics/jointed_bodies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/evidence.hpp"
#include "battery/generators.hpp"
#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference::jointed_bodies_test {

/// Two formulations, each with its rounding after 10 s; scale: 1 + momentum, angles in rad.
constexpr double momentum_rounding = 1.4e-14;  // kg m2/s, of some 1
constexpr double agreement = 2e-12, agreement_under_torques = 1e-12;
/// Constraints that nothing pulls back, after 10 s; scale: 1 m, 1 rad.
constexpr double drift = 1e-12;

constexpr double duration = 10.0;

JointedCone cone(double azimuth, double mass, double axial) {
  JointedCone c;
  c.mass = mass;
  c.axis_B = Vec3(0.8 * std::cos(azimuth), 0.8 * std::sin(azimuth), 0.6);
  c.bearing_B = Vec3(0.1 * std::cos(azimuth), 0.1 * std::sin(azimuth), 0.2);
  c.offset = 0.15;
  c.axial_inertia = axial;
  c.transverse_inertia = 0.7 * axial;
  return c;
}

/// An unsymmetric body with its centre off the origin, and cones of unequal mass.
JointedBit bit(std::size_t cones, Mount mount) {
  JointedBit b;
  b.body.mass = 3.0;
  b.body.centre_B = Vec3(0.05, -0.02, 0.3);
  b.body.inertia_B << 1.5, 0.1, 0.0, 0.1, 1.8, -0.05, 0.0, -0.05, 2.1;
  for (std::size_t k = 0; k < cones; ++k) {
    const double n = static_cast<double>(k);
    b.cones.push_back(cone(2.0 * std::numbers::pi * n / 3.0 + 0.1, 0.4 + 0.1 * n, 0.08 + 0.03 * n));
  }
  b.mount = mount;
  b.gravity = mount == Mount::pinned ? -4.0 : 0.0;  // upwards: the top stands on its pin
  b.loads.resize(cones);
  return b;
}

JointedState thrown(std::size_t cones) {
  JointedState s;
  s.R_WB = Mat3(Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()));
  s.w_B = Vec3(0.7, -0.5, 2.0);
  s.spins = std::vector<double>{-7.0, 3.0, -9.0};
  s.spins.resize(cones);
  return s;
}

/// The same start in the gyrostat's unknowns, from their definitions in src/dynamics.
GyrostatState gyrostat_start(const dynamics::Gyrostat& g, const JointedState& s) {
  GyrostatState start;
  start.R_WB = s.R_WB;
  start.body_momentum_B = g.inertia_B * s.w_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const dynamics::Cone& c = g.cones[k];
    start.cone_angles.push_back(0.0);
    start.cone_momenta.push_back(c.axial_inertia * (s.spins[k] + c.axis_B.dot(s.w_B)));
    start.body_momentum_B += c.axial_inertia * s.spins[k] * c.axis_B;
  }
  return start;
}

double difference(const dynamics::Gyrostat& g, const GyrostatState& a, const JointedState& b) {
  double d = (a.R_WB - b.R_WB).norm() + (bit_angular_velocity(g, a) - b.w_B).norm() +
             (a.R_WB * a.body_momentum_B - b.momentum_W).norm();
  for (std::size_t k = 0; k < b.spins.size(); ++k)
    d += std::abs(a.cone_angles[k] - b.cone_angles[k]) +
         std::abs(a.cone_momenta[k] - b.cone_momenta[k]);
  return d;
}

struct Comparison {
  double difference = 0.0;  ///< over 1 + momentum
  JointedRun jointed;
};

Comparison compare(const JointedBit& b, const JointedState& start, double t_end) {
  const EquivalentGyrostat e = equivalent(b);
  const GyrostatState first = gyrostat_start(e.gyrostat, start);
  const GyrostatState expected = runge_kutta(e.gyrostat, e.loads, first, t_end).state;
  const JointedRun run = jointed_run(b, start, t_end);
  return {difference(e.gyrostat, expected, run.state) / (1.0 + expected.body_momentum_B.norm()),
          run};
}

std::string name_of(const JointedBit& b) {
  return std::string(b.mount == Mount::free ? "free" : "heavy top") + " with " +
         std::to_string(b.cones.size()) + " cones";
}

/// One line of evidence for a claim of chapter 5.
void tell(const std::string& claim, const std::string& what, double measured,
          const std::string& unit, double limit) {
  const bool holds = measured <= limit;
  battery::record({claim, what, measured, unit, fmt::format("<= {:.0e}", limit),
                   holds ? battery::Verdict::holds : battery::Verdict::refuted});
  EXPECT_TRUE(holds) << what << ": " << measured;
}

void expect_agreement(const JointedBit& b, const std::string& loads, double limit) {
  const Comparison c = compare(b, thrown(b.cones.size()), duration);
  const std::string name = name_of(b) + loads;
  tell("chapter5/equations",
       "equations of the gyrostat against jointed rigid bodies, " + name + ", after 10 s",
       c.difference, "1", limit);
  tell("chapter5/any-number-of-cones", "gap of the jointed bodies' bearings, " + name,
       c.jointed.largest_gap, "m", drift);
  tell("chapter5/any-number-of-cones", "tilt of the jointed bodies' bearings, " + name,
       c.jointed.largest_tilt, "rad", drift);
}

TEST(JointedBodies, move_as_the_gyrostat_says) {
  for (const Mount mount : {Mount::free, Mount::pinned})
    for (const std::size_t cones : {0u, 1u, 3u}) expect_agreement(bit(cones, mount), "", agreement);
}

TEST(JointedBodies, torques_on_cones_act_as_the_gyrostat_says) {
  for (const Mount mount : {Mount::free, Mount::pinned}) {
    JointedBit b = bit(3, mount);
    b.torque_B = Vec3(0.3, -0.2, 0.5);
    b.loads = {{0.1, 0.0, 0.02}, {0.0, -0.2, 0.0}, {-0.05, 0.15, 0.01}};
    expect_agreement(b, " and torques", agreement_under_torques);
  }
}

/// Any inertia a body can have: principal values are sums of two moments of mass.
rc::Gen<Mat3> any_inertia() {
  return rc::gen::apply(
      [](const Mat3& R, double x, double y, double z) {
        return Mat3(R * Vec3(y + z, z + x, x + y).asDiagonal() * R.transpose());
      },
      battery::rotation(), battery::number(0.1, 2.0), battery::number(0.1, 2.0),
      battery::number(0.1, 2.0));
}

JointedCone any_cone() {
  JointedCone c;
  c.mass = *battery::number(0.1, 1.0);
  c.bearing_B = *battery::point(0.3);
  c.axis_B = *battery::direction();
  c.offset = *battery::number(-0.3, 0.3);
  c.axial_inertia = *battery::number(0.02, 0.3);
  c.transverse_inertia = c.axial_inertia * *battery::number(0.5, 2.0);
  return c;
}

/// Also: the check of inertias takes every real bit with cones.
RC_GTEST_PROP(JointedBodies, any_bit_moves_as_the_gyrostat_says, ()) {
  JointedBit b;
  b.body = {*battery::number(1.0, 5.0), *battery::point(0.3), *any_inertia()};
  JointedState start;
  start.R_WB = *battery::rotation();
  start.w_B = *battery::point(3.0);
  for (int k = *battery::integer(0, 3); k > 0; --k) {
    b.cones.push_back(any_cone());
    b.loads.push_back(
        {*battery::number(-0.2, 0.2), *battery::number(-0.2, 0.2), *battery::number(0.0, 0.05)});
    start.spins.push_back(*battery::number(-8.0, 8.0));
  }
  b.mount = *rc::gen::element(Mount::free, Mount::pinned);
  b.gravity = b.mount == Mount::pinned ? *battery::number(-5.0, 5.0) : 0.0;
  RC_ASSERT(compare(b, start, 0.5).difference < agreement_under_torques);
}

TEST(JointedBodies, keep_momentum_and_energy) {
  for (const Mount mount : {Mount::free, Mount::pinned}) {
    const JointedState early = jointed_run(bit(3, mount), thrown(3), 1e-9).state;
    const JointedState late = jointed_run(bit(3, mount), thrown(3), duration).state;
    EXPECT_NEAR(late.energy, early.energy, agreement_under_torques);
    EXPECT_NEAR(late.momentum_W.z(), early.momentum_W.z(), agreement);
    if (mount == Mount::pinned) continue;
    EXPECT_LE((late.momentum_W - early.momentum_W).norm(), momentum_rounding);
  }
}

/// The locked inertia of two points on a line, by hand.
TEST(JointedBodies, equivalent_inertia_follows_steiner) {
  JointedBit b;
  b.body = {2.0, Vec3(0, 0, 1), Mat3(Vec3(1, 1, 1).asDiagonal())};
  JointedCone c;
  c.mass = 2.0;
  c.bearing_B = Vec3(0, 0, 2);
  c.offset = 1.0;
  c.axial_inertia = 0.2;
  c.transverse_inertia = 0.3;
  b.cones = {c};
  b.gravity = -5.0;
  EXPECT_LE((equivalent(b).gyrostat.inertia_B - Mat3(Vec3(5.3, 5.3, 1.2).asDiagonal())).norm(),
            1e-14);
  EXPECT_EQ(equivalent(b).loads.gravity_moment, 0.0);
  b.mount = Mount::pinned;
  EXPECT_LE((equivalent(b).gyrostat.inertia_B - Mat3(Vec3(21.3, 21.3, 1.2).asDiagonal())).norm(),
            1e-14);
  EXPECT_DOUBLE_EQ(equivalent(b).loads.gravity_moment, 4.0 * 5.0 * 2.0);
  EXPECT_EQ(equivalent(b).loads.gravity_arm_B, Vec3(0, 0, 1));
}

}  // namespace tdbd::reference::jointed_bodies_test

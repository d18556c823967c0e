#include "reference/dynamics/jointed_bodies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/evidence.hpp"
#include "battery/generators.hpp"
#include "reference/dynamics/lumped_drilling.hpp"
#include "reference/dynamics/runge_kutta.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

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

TEST(JointedBodies, move_like_the_gyrostat) {
  for (const Mount mount : {Mount::free, Mount::pinned})
    for (const std::size_t cones : {0u, 1u, 3u}) expect_agreement(bit(cones, mount), "", agreement);
}

TEST(JointedBodies, torques_on_cones_act_as_on_the_gyrostat) {
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
RC_GTEST_PROP(JointedBodies, any_bit_moves_like_the_gyrostat, ()) {
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

/// The locked inertia of two points on a line, computed manually.
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

namespace tdbd::reference::lumped_drilling_test {

using dynamics::AxialMode;
using dynamics::DamperEnd;
using dynamics::DrillingSystem;

/// Stored energy of a state by the twin's own formulas, J.
double stored(const DrillingSystem& s, const LumpedState& x) {
  const double eccentricity =
      (x.c_W + x.bit.R_WB * (Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B)).head<2>().norm();
  const double depth = std::max(eccentricity - s.wall.clearance, 0.0);
  return total_energy(s.gyrostat, {}, x.bit) + 0.5 * s.mass * x.v_W.squaredNorm() +
         0.5 * s.rock.mass * x.rock_v * x.rock_v + 0.5 * s.rock.stiffness * x.rock_z * x.rock_z +
         0.5 * s.wall.stiffness * depth * depth + string_energy(s, x);
}

/// Its springs come from differences of an energy, its top works by that energy's change, and
/// losses are integrated apart: that the sum stays put ties them together.
TEST(LumpedDrilling, its_energy_is_accounted_for) {
  for (const AxialMode axial : {AxialMode::rate, AxialMode::load})
    for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
      const DrillingSystem s = dynamics::coupled_bit(axial, end);
      const LumpedState from = lumped_state(s, dynamics::coupled_start(s));
      const LumpedRun run = lumped_drilling(s, dynamics::smooth_law, from, 0.5);
      const LumpedEnergy& e = run.energy;
      const double in = e.top + e.gravity + e.cut_bit + e.cut_rock;
      const double lost =
          e.damped_string + e.damped_bearings + e.damped_rock + e.wall_loss + e.wall_friction;
      EXPECT_NEAR(stored(s, run.state) - stored(s, from), in - lost, 1e-12 * stored(s, from));
    }
}

/// Spring, mass and damper along z, and a torsional pendulum: closed forms.
TEST(LumpedDrilling, damped_oscillations_are_the_closed_forms) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.string.stiffness.diagonal().z() = 7e5;
  s.string.damping.diagonal().z() = 3e3;
  s.string.turn_stiffness.diagonal().z() = 938.0;
  s.string.turn_damping.diagonal().z() = 5.0;
  LumpedState from;
  from.c_W.z() = 0.01;
  from.bit.twist = 0.5;
  from.bit.R_WB = Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
  const LumpedState end = lumped_drilling(s, nullptr, from, 1.0).state;
  const auto ring = [](double inertia, double damping, double stiffness, double t) {
    const double decay = 0.5 * damping / inertia;
    const double w = std::sqrt(stiffness / inertia - decay * decay);
    return std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
  };
  EXPECT_NEAR(end.c_W.z(), 0.01 * ring(500.0, 3e3, 7e5, 1.0), 1e-12);
  EXPECT_NEAR(end.bit.twist, 0.5 * ring(2.0, 5.0, 938.0, 1.0), 1e-12);
}

/// Without a string it is the gyrostat's own twin.
TEST(LumpedDrilling, a_free_bit_is_the_free_gyrostat) {
  DrillingSystem s = dynamics::coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string = {};
  s.wall = {};
  s.rock = {};
  s.bearing_damping = {0.0, 0.0};
  s.gravity = 0.0;
  const LumpedState from = lumped_state(s, dynamics::coupled_start(s));
  const LumpedState end = lumped_drilling(s, nullptr, from, 0.8).state;
  const GyrostatState alone = runge_kutta(s.gyrostat, {}, from.bit, 0.8).state;
  EXPECT_LT((end.bit.R_WB - alone.R_WB).norm(), 1e-12);
  EXPECT_LT((end.bit.body_momentum_B - alone.body_momentum_B).norm(), 1e-12);
  EXPECT_LT((end.c_W - from.c_W - 0.8 * from.v_W).norm(), 1e-12);
}

/// The rock takes what the bit gives, and both move as the masses say.
TEST(LumpedDrilling, free_rock_and_bit_keep_their_momentum) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.rock.mass = 280.0;
  LumpedState from;
  from.v_W.z() = 0.1;
  const LumpedLaw contact = [](const auto&, const dynamics::DrillingState& x, const auto&,
                               dynamics::Wrench& w) {
    w.force_W.z() = -8.6e6 * std::max(x.c_W.z() - x.rock_z, 0.0);
    w.rock_force = -w.force_W.z();
  };
  const LumpedState end = lumped_drilling(s, contact, from, 0.02, {1e-12, 1e-12}).state;
  EXPECT_NEAR(end.v_W.z(), 0.1 * (500.0 - 280.0) / 780.0, 1e-12);
  EXPECT_NEAR(end.rock_v, 0.1 * 1000.0 / 780.0, 1e-12);
}

/// A staircase's jump falls between two integrations.
TEST(LumpedDrilling, a_stair_of_load_is_met_at_its_edge) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.top.axial = AxialMode::load;
  s.top.load = dynamics::make_schedule(dynamics::Interpolation::stepwise, {0.0, 0.3}, {0.0, 1e3});
  const LumpedRun run = lumped_drilling(s, nullptr, LumpedState{}, 1.0);
  const LumpedState& end = run.state;
  EXPECT_LT(run.evaluations, 500);  // no creeping up to the edge
  EXPECT_NEAR(end.v_W.z(), 0.7 * 1e3 / 500.0, 1e-12);
  EXPECT_NEAR(end.c_W.z(), 0.5 * 0.7 * 0.7 * 1e3 / 500.0, 1e-12);
}

}  // namespace tdbd::reference::lumped_drilling_test

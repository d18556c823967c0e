#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/observed_order.hpp"
#include "dynamics/drilling/wall_secants.hpp"
#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

/// A block pressed on a wall and pushed along it. Closed forms that hold at any time step.
namespace tdbd::dynamics::wall_friction_test {

constexpr double mass = 500.0;        ///< kg
constexpr double pressed = 62'500.0;  ///< N
constexpr double friction = 0.8;
constexpr double bound = friction * pressed;  ///< N, of the friction
constexpr double stiffness = 1e6;             ///< N/m; a stable step may be 40 ms
constexpr double slip_speed = 1e-3;           ///< m/s

/// The ring has no radius, so that friction turns nothing.
DrillingSystem block_on_wall(double restitution, double v0 = slip_speed) {
  DrillingSystem s = plain_bit();
  s.mass = mass;
  s.wall = {
      .stiffness = stiffness, .restitution = restitution, .friction = friction, .slip_speed = v0};
  return make_drilling_system(s);
}

LumpedLaw push(double along_z) {
  return [along_z](const DrillingSystem&, const DrillingState&, const DrillingVelocity&,
                   Wrench& w) { w.force_W = Vec3(pressed, 0.0, along_z); };
}

/// At rest where the wall's mean spring pushes back with `spring` times the pressing force.
DrillingState resting(const DrillingSystem& s, double spring = 1.0) {
  DrillingState x = at_rest(s);
  x.c_W.x() = spring * pressed / mean_wall_stiffness(s.wall);
  return x;
}

/// Speed of the drifts along z over `steps` steps, after as many for the start to fade.
double mean_speed(const DrillingSystem& s, const LumpedLaw& law, double h, int steps,
                  DrillingRun& d) {
  for (int i = 0; i < steps; ++i) step(s, law, h, d);
  const double from = d.state.c_W.z();
  for (int i = 0; i < steps; ++i) step(s, law, h, d);
  return (d.state.c_W.z() - from) / (steps * h);
}

/// v0 atanh(F/(mu P)). The normal force is the pressing force P wherever in the band of the wall's
/// loss the block rests: to rounding, but for the depth that it creeps within a step.
TEST(WallFriction, a_pushed_block_creeps_at_the_speed_that_bears_the_push) {
  double balanced = 0.0, creeping = 0.0;
  for (const double share : {0.1, 0.5, 0.9})
    for (const double h : {1e-2, 1e-3, 1e-4, 1e-5})
      for (const auto& [restitution, spring] :
           {std::pair{1.0, 1.0}, std::pair{0.5, 0.9}, std::pair{0.5, 1.0}, std::pair{0.5, 1.2}}) {
        const DrillingSystem s = block_on_wall(restitution);
        const LumpedLaw law = push(share * bound);
        DrillingRun d = start(s, law, resting(s, spring));
        const double radius = d.state.c_W.x();
        const double exact = slip_speed * std::atanh(share);
        const double deviation = std::abs(mean_speed(s, law, h, 400, d) / exact - 1.0);
        double& worst = spring == 1.0 ? balanced : creeping;
        worst = std::max(worst, deviation);
        EXPECT_LT(std::abs(d.state.c_W.x() - radius), 800 * h * radial_creep);
      }
  EXPECT_LT(balanced, 3e-13);
  EXPECT_LT(creeping, 1e-8);
}

TEST(WallFriction, a_block_pushed_harder_than_friction_accelerates_by_the_rest) {
  for (const double h : {1e-2, 1e-3, 1e-4}) {
    const DrillingSystem s = block_on_wall(0.5);
    const LumpedLaw law = push(1.5 * bound);
    DrillingState from = resting(s);
    from.momentum_W.z() = mass;  // 1 m/s: tanh is 1
    DrillingRun d = start(s, law, from);
    for (int i = 0; i < 100; ++i) step(s, law, h, d);
    const double exact = mass + 0.5 * bound * 100 * h;
    EXPECT_NEAR(d.state.momentum_W.z(), exact, 1e-11 * exact) << h;
  }
}

/// M v^2/(2 mu P) and M v^2/2. It stops within a step, so that its way is known to h v/2.
TEST(WallFriction, a_thrown_block_slides_as_far_as_its_energy_lasts) {
  constexpr double v = 1.0;
  for (const double h : {1e-3, 2.5e-4, 1e-4}) {
    const DrillingSystem s = block_on_wall(0.5);
    DrillingState from = resting(s);
    from.momentum_W.z() = mass * v;
    DrillingRun d = start(s, push(0.0), from);
    while (d.state.rotation.time < 0.05) step(s, push(0.0), h, d);
    EXPECT_NEAR(d.state.c_W.z(), 0.5 * mass * v * v / bound, 2e-5) << h;  // of 5 mm
    EXPECT_NEAR(d.ledger.wall_friction, 0.5 * mass * v * v, 1e-3) << h;   // of 250 J
    EXPECT_LT(std::abs(d.state.momentum_W.z()), 1e-9 * mass) << h;
  }
}

TEST(WallFriction, coulomb_friction_stops_a_block_that_is_pushed_below_its_bound) {
  for (const double h : {1e-2, 1e-3, 1e-4})
    for (const double share : {0.1, 0.9, -0.9}) {
      const DrillingSystem s = block_on_wall(0.5, 0.0);
      const LumpedLaw law = push(share * bound);
      DrillingRun d = start(s, law, resting(s));
      const double speed = mean_speed(s, law, h, 50, d);
      EXPECT_LT(std::abs(speed), 2e-9) << h << " s, " << share;
    }
}

/// A constant force against a damper of rate c/M = 2e4 1/s: F/c at any step, beside the wall and on
/// it. The kicked step moved it (h/2) F/M coth(h c/2M) in place of that.
TEST(WallFriction, under_a_stiff_damper_a_load_moves_at_force_over_damping) {
  constexpr double damping = 2e4 * mass, force = 3e4;
  for (const bool touches : {false, true})
    for (const double h : {3e-2, 1e-2, 1e-3, 1e-4}) {
      DrillingSystem s = block_on_wall(0.5);
      s.string.damping.diagonal().z() = damping;
      s.wall.friction = 0.0;
      if (!touches) s.wall.clearance = 10.0;
      s = make_drilling_system(s);
      const LumpedLaw law = push(force);
      DrillingRun d = start(s, law, resting(s));
      EXPECT_NEAR(mean_speed(s, law, h, 50, d), force / damping, 1e-13 * force / damping) << h;
    }
}

/// Of second order once the step resolves the spring against the damper, and never too fast.
TEST(WallFriction, a_lean_relaxes_against_its_stiff_damper) {
  constexpr double inertia = 8.0, turn_damping = 1e5, turn_stiffness = 1e7, end = 0.02;
  DrillingSystem s = plain_bit();
  s.wall = {.stiffness = 1e8, .clearance = 1.0};
  s.string.turn_stiffness.diagonal().x() = turn_stiffness;
  s.string.turn_damping.diagonal().x() = turn_damping;
  s = make_drilling_system(s);
  constexpr double lean = 1e-4;
  const double root = std::sqrt(turn_damping * turn_damping - 4.0 * inertia * turn_stiffness);
  const double slow = (turn_damping - root) / (2.0 * inertia),
               fast = (turn_damping + root) / (2.0 * inertia);
  const double exact =
      lean * (fast * std::exp(-slow * end) - slow * std::exp(-fast * end)) / (fast - slow);
  std::vector<double> steps, errors;
  for (const double h : {1e-3, 5e-4, 2.5e-4, 1.25e-4, 6.25e-5, 3.125e-5, 1.5625e-5}) {
    DrillingState from = at_rest(s);
    from.rotation.q_WB = Eigen::AngleAxisd(lean, Vec3::UnitX());
    DrillingRun d = start(s, nullptr, from);
    while (d.state.rotation.time < end - 0.5 * h) step(s, nullptr, h, d);
    const double found = Eigen::AngleAxisd(d.state.rotation.q_WB).angle();
    steps.push_back(h);
    errors.push_back(std::abs(found / exact - 1.0));
  }
  EXPECT_LT(errors.front(), 0.2);
  EXPECT_NEAR(least_squares_order(std::span(steps).last(5), std::span(errors).last(5)), 2.0, 0.3);
}

}  // namespace tdbd::dynamics::wall_friction_test

namespace tdbd::dynamics::wall_secants_test {

using Complex = std::complex<double>;

/// Ten to a power in [lo, hi].
double power_of_ten(double lo, double hi) { return std::pow(10.0, *battery::number(lo, hi)); }

/// A contact that moves by itself, without dampers: mobility A^T M^-1 A of three directions, speeds
/// `start` and accelerations `push` over a time.
struct Contact {
  Mat3 mobility = Mat3::Identity();
  Vec3 start = Vec3::Zero(), push = Vec3::Zero();
  double time = 0.0;
};
WallResponse response_of(const Contact& c) {
  const Complex factor(1.0, -1.0);
  return {c.mobility.cast<Complex>() * (c.time / factor),
          (factor * c.start + (c.time * c.push).cast<Complex>()) / factor};
}

/// Any contact: heavy and light, fast and at rest, pushed hard or not.
Contact any_contact() {
  Contact c;
  Mat3 half = Mat3::Identity();
  for (int i = 0; i < 9; ++i) half(i / 3, i % 3) += *battery::number(-0.5, 0.5);
  c.mobility = power_of_ten(-4.0, 0.0) * half * half.transpose();
  c.start = power_of_ten(-6.0, 1.0) * *battery::point(1.0);
  c.push = power_of_ten(-2.0, 4.0) * *battery::point(1.0);
  c.time = power_of_ten(-6.0, 0.0);
  return c;
}

WallLaw any_law() {
  const double restitution = *rc::gen::element(0.0, 0.3, 0.7, 1.0), e2 = restitution * restitution;
  const double depth_force = power_of_ten(-1.0, 6.0);
  return {*rc::gen::element(0.0, 0.05, 0.5, 2.0), *rc::gen::element(0.0, 1e-6, 1e-3, 1.0),
          0.5 * depth_force * (1.0 + e2), 0.5 * depth_force * (1.0 - e2)};
}

/// By how much the forces of the secants differ from those of the laws at the speeds that they lead
/// to, of the largest force of each law.
double disagreement(const WallLaw& law, const WallResponse& r, const WallSecants& g) {
  const Vec3 v = contact_speeds(r, g).real();
  const double slip = v.head<2>().norm(), v0 = std::max(law.slip_speed, coulomb_creep);
  const double radial = std::abs(v[2]), most = law.spring + law.loss;
  const double lost = law.loss * std::min(radial / radial_creep, 1.0);
  const double normal = law.spring + std::copysign(lost, v[2]);
  const double in_slip = g.slip * slip / most - law.friction * normal / most * std::tanh(slip / v0);
  const double in_radius = (g.radial * radial - lost) / most;
  return std::max(std::abs(in_slip) / std::max(law.friction, 1e-300), std::abs(in_radius));
}

RC_GTEST_PROP(WallSecants, agree_with_the_laws_at_the_speeds_they_lead_to, ()) {
  const WallLaw law = any_law();
  const Contact c = any_contact();
  const WallResponse r = response_of(c);
  SecantSearch search;
  const WallSecants g = find_wall_secants(law, r, c.start, &search);
  RC_CLASSIFY(search.bracketed);
  RC_ASSERT(disagreement(law, r, g) < 2e-10);  // 8e-11 in 20 000 contacts
}

/// A contact at rest that is pushed less than friction bears stays at rest, within its creep.
TEST(WallSecants, stop_a_contact_that_is_pushed_below_its_friction) {
  const WallLaw law{0.5, 1e-3, 1e4, 0.0};                                             // bears 5 kN
  const Contact c{1e-2 * Mat3::Identity(), Vec3::Zero(), Vec3(30.0, 0.0, 0.0), 1.0};  // 3 kN
  SecantSearch search;
  const WallResponse r = response_of(c);
  const WallSecants g = find_wall_secants(law, r, c.start, &search);
  EXPECT_FALSE(search.bracketed);
  EXPECT_NEAR(contact_speeds(r, g).real()[0], 1e-3 * std::atanh(0.6), 6e-5 * 1e-3);
  EXPECT_EQ(g.radial, 0.0);
}

/// Newton's method needs few steps from the speeds of a contact that slides on.
TEST(WallSecants, take_few_newton_steps_where_the_slip_continues) {
  const WallLaw law{0.5, 1e-3, 1e4, 5e3};
  const Contact c{1e-3 * Mat3::Identity(), Vec3(0.3, 0.2, 0.05), Vec3(10.0, 0.0, 0.0), 1e-3};
  SecantSearch search;
  const WallSecants g = find_wall_secants(law, response_of(c), c.start, &search);
  EXPECT_FALSE(search.bracketed);
  EXPECT_LE(search.newton_steps, 5);
  const Vec3 v = contact_speeds(response_of(c), g).real();
  EXPECT_NEAR(g.slip * v.head<2>().norm(), 0.5 * 1.5e4, 1e-8);  // moves in: N = spring + loss
  EXPECT_NEAR(g.radial * v[2], 5e3, 1e-8);
}

}  // namespace tdbd::dynamics::wall_secants_test

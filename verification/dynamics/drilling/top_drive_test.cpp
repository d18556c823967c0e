#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/observed_order.hpp"
#include "dynamics/drilling/resisted_flow.hpp"
#include "dynamics/drilling/stability.hpp"
#include "rotation/quaternion.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

namespace tdbd::dynamics::top_drive_test {

constexpr double h = 1e-3;  ///< s

/// Rock that resists with 8.6e6 N a metre of depth, and a torque in proportion.
void springy_rock(const DrillingSystem&, const DrillingState& x, const DrillingVelocity&,
                  Wrench& w) {
  w.force_W.z() = -8.6e6 * std::max(x.c_W.z(), 0.0);
  w.torque_W.z() = 0.1 * w.force_W.z();
}

DrillingSystem damped_bit() {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness.diagonal() = Vec3(7e5, 7e5, 7e5);
  s.string.damping.diagonal() = Vec3(3e4, 3e4, 1e5);
  s.string.turn_stiffness.diagonal() = Vec3(1e5, 1e5, 938.0);
  s.string.turn_damping.diagonal() = Vec3(1e3, 1e3, 300.0);
  return s;
}

/// Weight on bit: a staircase of loads is what the rock carries, whatever the bit weighs.
TEST(TopDrive, staircase_of_loads_is_the_weight_on_bit) {
  DrillingSystem s = damped_bit();
  s.top.axial = AxialMode::load;
  s.top.load = make_schedule(Interpolation::stepwise, {0.0, 1.0, 2.0}, {5e3, 2e4, 1e4});
  s = make_drilling_system(s);
  DrillingRun d = start(s, springy_rock, at_rest(s));
  for (const double load : {5e3, 2e4, 1e4}) {
    for (int i = 0; i < 999; ++i) step(s, springy_rock, h, d);
    EXPECT_NEAR(-d.wrench.force_W.z(), load, 1e-12 * load);
    step(s, springy_rock, h, d);
  }
}

/// An axial damper to space takes its part of the load while the bit drills on; one to the top
/// takes none when the top knows the rate.
TEST(TopDrive, damper_to_the_top_leaves_the_load_on_the_bit) {
  constexpr double load = 2e4, rate = 15.0 / 3600.0;
  const LumpedLaw viscous = [](const auto&, const auto&, const DrillingVelocity& v, Wrench& w) {
    w.force_W.z() = -load / rate * v.v_W.z();  // drills at `rate` under `load`
  };
  for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
    DrillingSystem s = damped_bit();
    s.mass = 1e4;
    s.string.damping(2, 2) = 1.4e5;
    s.string.damper_end = end;
    s.top = {{}, AxialMode::load, constant(rate), constant(load)};
    s = make_drilling_system(s);
    DrillingRun d = start(s, viscous, at_rest(s));
    for (int i = 0; i < 1000; ++i) step(s, viscous, 1e-4, d);
    const double taken = end == DamperEnd::space ? load * 1.4e5 / (1.4e5 + load / rate) : 0.0;
    EXPECT_NEAR(-d.wrench.force_W.z(), load - taken, 6.5e-9 * load);
  }
}

/// A bit that follows `load` through rock of viscosity c, its damper to a top that follows it.
struct FollowedBit {
  double mass = 1e4, damping = 1.4e5, rock = 5e5, load = 2e4, following_time = 0.05;

  DrillingSystem system() const {
    DrillingSystem s = plain_bit();
    s.gravity = 9.81;
    s.mass = mass;
    s.string.damping(2, 2) = damping;
    s.string.damper_end = DamperEnd::top;
    s.top.axial = AxialMode::load;
    s.top.load = constant(load);
    s.top.following_time = following_time;
    return make_drilling_system(s);
  }
  /// The same beside a wall that the bit does not touch: forces and dampers act in one flow.
  DrillingSystem system_with_wall() const {
    DrillingSystem s = system();
    s.wall.stiffness = 1e6;
    s.wall.clearance = 1.0;
    return s;
  }
  LumpedLaw law() const {
    return [c = rock](const auto&, const auto&, const DrillingVelocity& v, Wrench& w) {
      w.force_W.z() = -c * v.v_W.z();
    };
  }
  DrillingRun started(double speed, double top_rate) const {
    const DrillingSystem s = system();
    DrillingState from = at_rest(s);
    from.momentum_W.z() = mass * speed;
    from.top_rate = top_rate;
    return start(s, law(), from);
  }
  /// The velocities of bit and top after a time: M v' = W - c v - D (v - r), r' = (v - r) / tau.
  Eigen::Vector2d exact(double speed, double top_rate, double time) const {
    Eigen::Matrix2d A;
    A << -(rock + damping) / mass, damping / mass, 1.0 / following_time, -1.0 / following_time;
    const Eigen::Vector2d steady = Eigen::Vector2d::Constant(load / rock);
    const Eigen::EigenSolver<Eigen::Matrix2d> modes(A);
    const Eigen::Vector2cd of = modes.eigenvectors().colPivHouseholderQr().solve(
        (Eigen::Vector2d(speed, top_rate) - steady).cast<std::complex<double>>());
    const Eigen::Vector2cd grown = (time * modes.eigenvalues().array()).exp() * of.array();
    return steady + (modes.eigenvectors() * grown).real();
  }
};

/// A top that follows the bit: whatever rate was expected, the rock carries the load.
TEST(TopDrive, that_follows_the_bit_leaves_the_load_on_it) {
  const FollowedBit bit;
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    for (const double expected : {0.0, 0.04, 1.0}) {
      DrillingRun d = bit.started(expected, expected);
      for (int i = 0; i < 3000; ++i) step(s, bit.law(), h, d);
      EXPECT_NEAR(-d.wrench.force_W.z(), bit.load, 1e-12 * bit.load) << expected;
      EXPECT_NEAR(d.state.top_rate, bit.load / bit.rock, 1e-13) << expected;
    }
}

TEST(TopDrive, that_follows_the_bit_moves_as_its_equations_do) {
  const FollowedBit bit;
  constexpr double time = 0.08, speed = 0.3, top_rate = -0.1;
  const Eigen::Vector2d exact = bit.exact(speed, top_rate, time);
  const auto error = [&](const DrillingSystem& s, int count) {
    DrillingRun d = bit.started(speed, top_rate);
    for (int i = 0; i < count; ++i) step(s, bit.law(), time / count, d);
    return Eigen::Array2d(velocity(s, d.state).v_W.z() - exact[0], d.state.top_rate - exact[1]);
  };
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    for (const int count : {80, 160}) {
      const Eigen::Array2d order =
          (error(s, count) / error(s, 2 * count)).abs().log() / std::log(2.0);
      EXPECT_NEAR(order[0], 2.0, 0.1) << "bit";
      EXPECT_NEAR(order[1], 2.0, 0.1) << "top";
    }
}

/// The dampers' loss and the top's work are in the ledger: what is left is of second order.
TEST(TopDrive, that_follows_the_bit_has_a_ledger_of_second_order) {
  const FollowedBit bit;
  const auto left = [&](const DrillingSystem& s, int count) {
    DrillingRun d = bit.started(0.3, -0.1);
    double lost = 0.0;
    for (int i = 0; i < count; ++i) {
      step(s, bit.law(), 0.5 / count, d);
      EXPECT_GE(d.ledger.damped_string, lost);
      lost = d.ledger.damped_string;
    }
    EXPECT_GT(lost, 0.1 * d.ledger.start);
    return residual(s, d);
  };
  for (const DrillingSystem& s : {bit.system(), bit.system_with_wall()})
    EXPECT_NEAR(std::log2(left(s, 500) / left(s, 1000)), 2.0, 0.05);
}

/// Lowered at a rate: the string's spring is stretched by what the rock carries, less the weight.
TEST(TopDrive, lowering_presses_through_the_axial_spring) {
  DrillingSystem s = damped_bit();
  s.top.rate = make_schedule(Interpolation::stepwise, {0.0, 0.5}, {0.04, 0.0});  // 20 mm in all
  s = make_drilling_system(s);
  DrillingRun d = start(s, springy_rock, at_rest(s));
  for (int i = 0; i < 3000; ++i) step(s, springy_rock, h, d);
  const double depth = (7e5 * 0.02 + 500.0 * 9.81) / (7e5 + 8.6e6);
  EXPECT_NEAR(d.state.c_W.z(), depth, 1e-12 * depth);
}

/// A top that turns ten times winds up a held bit by as much, and the twist is torque over Kr.
TEST(TopDrive, windings_count) {
  DrillingSystem s = damped_bit();
  s.gravity = 0.0;
  s.top.speed = make_schedule(Interpolation::stepwise, {0.0, 10.0}, {2.0 * std::numbers::pi, 0.0});
  s = make_drilling_system(s);
  const LumpedLaw holds = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    w.torque_W.z() = -1e5 * rotation::twist_angle(x.rotation.q_WB, x.rotation.turns);
  };
  DrillingRun d = start(s, holds, at_rest(s));
  for (int i = 0; i < 15'000; ++i) step(s, holds, h, d);
  const double held = 938.0 * 20.0 * std::numbers::pi * 1e5 / (1e5 + 938.0);
  EXPECT_NEAR(d.wrench.torque_W.z(), -held, 1e-12 * held);
  EXPECT_NEAR(d.ledger.top, 0.5 * 938.0 * std::pow(20.0 * std::numbers::pi, 2), 2e4);
}

/// A ramp of speeds is followed with the lag of its acceleration, Kr lag = I acceleration, but for
/// an error of second order.
TEST(TopDrive, ramp_of_speeds_is_followed) {
  DrillingSystem s = damped_bit();
  s.gravity = 0.0;
  s.string.damper_end = DamperEnd::top;
  s.top.speed = make_schedule(Interpolation::linear, {0.0, 20.0}, {0.0, 20.0});
  s = make_drilling_system(s);
  constexpr double exact = 2.0 / 938.0, slow = 2e-5;
  std::vector<double> steps, errors;
  for (int n = 2500; n <= 40'000; n *= 2) {
    DrillingRun d = start(s, nullptr, at_rest(s));
    for (int i = 0; i < n; ++i) step(s, nullptr, 10.0 / n, d);
    const double lag = top_position(s, d.state).angle -
                       rotation::twist_angle(d.state.rotation.q_WB, d.state.rotation.turns);
    if (n == 10'000) {
      EXPECT_NEAR(velocity(s, d.state).w_W.z(), 10.0, slow);
    }
    steps.push_back(10.0 / n);
    errors.push_back(std::abs(lag - exact) / exact);
  }
  EXPECT_NEAR(least_squares_order(steps, errors), 2.0, 0.01);
  EXPECT_LT(errors.back(), 2e-4);
}

}  // namespace tdbd::dynamics::top_drive_test

namespace tdbd::dynamics::damper_test {

constexpr double rounding = 1e-12;  ///< of the energies, speeds or ways involved

/// h D / M from a thousandth to a million: the speed falls as an exponential, whatever the step.
TEST(Damper, is_the_exponential_whatever_the_step) {
  for (double x = 1e-3; x < 2e6; x *= 10.0) {
    DrillingSystem s = plain_bit();
    s.string.damping = (x * s.mass * Mat3::Identity()).eval();  // h = 1 s
    s = make_drilling_system(s);
    DrillingState from = at_rest(s);
    from.momentum_W = Vec3(3.0, -5.0, 7.0);
    DrillingRun d = start(s, nullptr, from);
    const double start_energy = d.ledger.start;
    double energy = start_energy;
    for (int i = 0; i < 20; ++i) {
      step(s, nullptr, 1.0, d);
      const double now = total(stored_energy(s, d.work.at, d.state));
      EXPECT_LE(now, energy);
      energy = now;
      const double left = std::exp(-x * (i + 1));
      EXPECT_NEAR(d.state.momentum_W.norm(), from.momentum_W.norm() * left,
                  rounding * from.momentum_W.norm());
      EXPECT_NEAR(d.ledger.damped_string + now, start_energy, rounding * start_energy);
    }
  }
}

/// A weight lowered against a damper at its terminal velocity, and a lean that relaxes against one:
/// the step moves both as fast as the forces do, up to a thousand times the damping that it resolves.
/// An impulse of half a step would move them by (h D / 2 M) coth(h D / 2 M) as fast.
TEST(Damper, that_is_stiff_lets_the_bit_move_as_fast_as_the_force_does) {
  constexpr double h = 1e-3, load = 1e4, spring = 1e3;
  for (const double x : {0.1, 1.0, 10.0, 100.0, 1000.0}) {
    DrillingSystem s = plain_bit();
    s.gravity = 0.0;
    const double c = x * s.mass / h, turning = x * 8.0 / h;  // N s/m, N m s/rad
    s.string.damping.diagonal().z() = c;
    s.string.turn_damping.diagonal().head<2>().setConstant(turning);
    s.string.turn_stiffness.diagonal().head<2>().setConstant(spring);
    s.top.axial = AxialMode::load;
    s.top.load = constant(load);
    s = make_drilling_system(s);
    DrillingState from = at_rest(s);
    const double lean = 1e-3, fall = spring / turning;  // 1/s: where inertia is nothing
    const Mat3 R = Eigen::AngleAxisd(lean, Vec3::UnitX()).toRotationMatrix();
    from.rotation = make_state(s.gyrostat, R, Vec3(-fall * lean, 0.0, 0.0), {}, {});
    from.momentum_W.z() = s.mass * load / c;
    DrillingRun d = start(s, nullptr, from);
    constexpr int n = 100;
    for (int i = 0; i < n; ++i) step(s, nullptr, h, d);
    EXPECT_NEAR(d.state.c_W.z(), n * h * load / c, rounding * n * h * load / c) << x;
    // The rate r of the slow motion: I r^2 - turning r + spring = 0.
    const double r = 2.0 * spring / (turning + std::sqrt(turning * turning - 32.0 * spring));
    const double left = bit_pose(s, d.state).R.transpose().coeff(1, 2);
    constexpr double within = 2e-3;  // at x = 0.1, where h r is 1/80
    EXPECT_NEAR(std::asin(left) / lean, std::exp(-n * h * r), within * n * h * r) << x;
  }
}

/// A flow of a state without forces.
struct Flow {
  DrillingState state;
  EnergyLedger ledger;
};
Flow flow_of(const DrillingSystem& s, double time) {
  Flow f{coupled_start(s), {}};
  Configuration at;
  configure(s, f.state, at);
  FlowWork work;
  work.force = Eigen::VectorXd::Zero(freedoms(s));
  resisted_flow(s, at, time, f.state, &f.ledger, work);
  return f;
}

/// Dampers of this size each, whatever their units, beside no wall.
DrillingSystem dampers_of(double size, DamperEnd end) {
  DrillingSystem s = coupled_bit(AxialMode::rate, end);
  s.wall = {};
  s.string.damping = size * Mat3::Identity();
  s.string.turn_damping = size * Mat3::Identity();
  s.bearing_damping = {size, size};
  s.rock.damping = size;
  return make_drilling_system(s);
}

void expect_same(const Flow& a, const Flow& b) {
  constexpr double same = 1e-13;  // of momenta and energies of some 100
  EXPECT_LT((a.state.momentum_W - b.state.momentum_W).norm(), same);
  EXPECT_LT((a.state.rotation.momentum_W - b.state.rotation.momentum_W).norm(), same);
  for (std::size_t k = 0; k < a.state.rotation.cone_momenta.size(); ++k)
    EXPECT_NEAR(a.state.rotation.cone_momenta[k], b.state.rotation.cone_momenta[k], same);
  EXPECT_NEAR(a.state.rock_momentum, b.state.rock_momentum, same);
  EXPECT_NEAR(a.ledger.top, b.ledger.top, same);
  EXPECT_NEAR(a.ledger.damped_string, b.ledger.damped_string, same);
  EXPECT_NEAR(a.ledger.damped_bearings, b.ledger.damped_bearings, same);
  EXPECT_NEAR(a.ledger.damped_rock, b.ledger.damped_rock, same);
}

/// Twice the damping for half the time takes the same: a coefficient counts by its product with time.
TEST(Damper, acts_by_coefficient_times_time) {
  for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
    const Flow once = flow_of(dampers_of(1.0, end), 0.2), half = flow_of(dampers_of(2.0, end), 0.1);
    expect_same(once, half);
    for (const double loss :
         {once.ledger.damped_string, once.ledger.damped_bearings, once.ledger.damped_rock})
      EXPECT_GT(loss, 1e-6);
    EXPECT_EQ(once.ledger.top == 0.0, end == DamperEnd::space);
  }
}

/// Rock that is held takes nothing, and nothing else is taken twice in its place.
TEST(Damper, is_the_same_beside_rock_that_is_held_or_loose) {
  DrillingSystem loose = dampers_of(1.0, DamperEnd::space), held = loose;
  loose.rock.damping = 0.0;
  held.rock.mass = 0.0;
  const Flow a = flow_of(loose, 0.2), b = flow_of(held, 0.2);
  expect_same(a, b);
  EXPECT_EQ(b.ledger.damped_rock, 0.0);
}

/// A damper that follows the top works on a bit at rest; the rest of the work is lost.
TEST(Damper, to_the_top_takes_its_work_from_the_top) {
  DrillingSystem s = plain_bit();
  s.string.turn_damping.diagonal().z() = 50.0;
  s.string.damping.diagonal().z() = 4e3;
  s.string.damper_end = DamperEnd::top;
  s.top.speed = constant(12.0);
  s.top.rate = constant(0.01);
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, nullptr, 0.1, d);
  const double kept = 0.5 * 2.0 * 12.0 * 12.0 + 0.5 * 500.0 * 0.01 * 0.01;  // as much as is lost
  EXPECT_NEAR(d.ledger.top, 2.0 * kept, rounding * kept);
  EXPECT_NEAR(d.ledger.damped_string, kept, rounding * kept);
  EXPECT_NEAR(velocity(s, d.state).w_W.z(), 12.0, 1e-12);
}

}  // namespace tdbd::dynamics::damper_test

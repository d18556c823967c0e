#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "dynamics/drilling/stability.hpp"
#include "dynamics/rotation/step.hpp"
#include "reference/dynamics/lumped_drilling.hpp"
#include "verification/battery/counted_memory.hpp"
#include "verification/battery/generators.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_system_test {

std::string problem(const std::function<void(DrillingSystem&)>& spoil) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  spoil(s);
  const std::string why = drilling_problem(s);
  if (!why.empty()) {
    EXPECT_THROW(make_drilling_system(s), InputError);
  }
  return why;
}

TEST(DrillingSystem, rejects_what_is_no_system) {
  using S = DrillingSystem;
  EXPECT_EQ(problem([](S&) {}), "");
  EXPECT_EQ(problem([](S& s) { s.mass = 0.0; }), "a mass of 0 kg");
  EXPECT_EQ(problem([](S& s) { s.gravity = std::nan(""); }), "gravity of nan m/s2");
  EXPECT_EQ(problem([](S& s) { s.integrator.order = 4; }),
            "an integrator of order 4: drilling has order 2");
  EXPECT_EQ(problem([](S& s) { s.string.stiffness(0, 1) += 1.0; }),
            "a string's stiffness that is not symmetric");
  EXPECT_EQ(problem([](S& s) { s.string.turn_damping = Vec3(1, 1, -2).asDiagonal(); }),
            "a string's rotational damping that is not positive: principal value -2");
  EXPECT_EQ(problem([](S& s) { s.string.damping(0, 0) = INFINITY; }),
            "a string's damping that is not finite");
  EXPECT_EQ(problem([](S& s) { s.wall.restitution = 1.01; }),
            "a wall's restitution of 1.01: at most 1");
  EXPECT_EQ(problem([](S& s) { s.wall.friction = -0.1; }), "a wall's friction of -0.1");
  EXPECT_EQ(problem([](S& s) { s.bearing_damping = {1.0}; }), "1 bearing dampings for 2 cones");
  EXPECT_EQ(problem([](S& s) { s.rock.damping = -1.0; }), "a rock mount's damping of -1");
}

/// Every number of wall, rock and bearings must be finite and not negative; 0 is none, and fine.
TEST(DrillingSystem, rejects_a_negative_or_undefined_number) {
  using Of = std::function<double&(DrillingSystem&)>;
  const std::vector<std::pair<std::string, Of>> numbers{
      {"a wall's stiffness", [](auto& s) -> double& { return s.wall.stiffness; }},
      {"a wall's clearance", [](auto& s) -> double& { return s.wall.clearance; }},
      {"a wall's ring of radius", [](auto& s) -> double& { return s.wall.ring_radius; }},
      {"a wall's restitution", [](auto& s) -> double& { return s.wall.restitution; }},
      {"a wall's friction", [](auto& s) -> double& { return s.wall.friction; }},
      {"a wall's slip speed", [](auto& s) -> double& { return s.wall.slip_speed; }},
      {"a top's following time", [](auto& s) -> double& { return s.top.following_time; }},
      {"a rock's mass", [](auto& s) -> double& { return s.rock.mass; }},
      {"a rock mount's stiffness", [](auto& s) -> double& { return s.rock.stiffness; }},
      {"a rock mount's damping", [](auto& s) -> double& { return s.rock.damping; }},
      {"a bearing's damping", [](auto& s) -> double& { return s.bearing_damping[1]; }}};
  for (const auto& [name, of] : numbers) {
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = 0.0; }), "") << name;
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = -1e-9; }), name + " of -1e-09");
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = INFINITY; }), name + " of inf");
  }
}

/// Each matrix and each vector by its name; a wall may give all back.
TEST(DrillingSystem, names_what_is_not_finite_or_not_positive) {
  using S = DrillingSystem;
  EXPECT_EQ(problem([](S& s) { s.mass = INFINITY; }), "a mass of inf kg");
  EXPECT_EQ(problem([](S& s) { s.centre_B.y() = INFINITY; }),
            "a centre of mass that is not finite");
  EXPECT_EQ(problem([](S& s) { s.wall.restitution = 1.0; }), "");
  for (const auto& [matrix, name] :
       {std::pair{&DrillString::stiffness, "a string's stiffness"},
        {&DrillString::damping, "a string's damping"},
        {&DrillString::turn_stiffness, "a string's rotational stiffness"},
        {&DrillString::turn_damping, "a string's rotational damping"}}) {
    const std::string that = std::string(name) + " that is not ";
    EXPECT_EQ(problem([&](S& s) { (s.string.*matrix)(1, 2) = INFINITY; }), that + "finite");
    EXPECT_EQ(problem([&](S& s) { (s.string.*matrix)(1, 2) += 1.0; }), that + "symmetric");
    EXPECT_EQ(problem([&](S& s) { s.string.*matrix = Vec3(-3.0, 1.0, 1.0).asDiagonal(); }),
              that + "positive: principal value -3");
  }
  for (Vec3 DrillString::*const place : {&DrillString::attachment_B, &DrillString::rest_W})
    EXPECT_EQ(problem([&](S& s) { (s.string.*place).x() = INFINITY; }),
              "a string's attachment or rest that is not finite");
}

/// What is negative by rounding alone is so beside the matrix's largest element.
TEST(DrillingSystem, recognises_rounding_by_the_size_of_the_matrix) {
  const auto with = [](double size, double least) {
    return problem([&](DrillingSystem& s) {
      s.string.stiffness = Vec3(size, size, least * size).asDiagonal();
    });
  };
  for (const double size : {1e-9, 1.0, 1e9}) {
    EXPECT_EQ(with(size, -1e-10), "");
    EXPECT_NE(with(size, -1e-8), "");
  }
}

/// A stiff spring along one way has none across it but for rounding, whatever its unit.
TEST(DrillingSystem, takes_a_spring_along_one_way) {
  const Vec3 way = Vec3(0.3, -0.5, 0.7).normalized();
  for (const double stiffness : {1e-6, 1.0, 1e6, 1e14})
    EXPECT_EQ(
        problem([&](DrillingSystem& s) { s.string.stiffness = stiffness * way * way.transpose(); }),
        "")
        << stiffness;
}

/// A damping without coupling is its own principal form: along x, y, z in this order, exactly.
TEST(DrillingSystem, uncoupled_dampers_stay_as_given) {
  DrillingSystem s = plain_bit();
  s.string.damping = Vec3(30.0, 10.0, 20.0).asDiagonal();
  s.string.turn_damping = Vec3(2.0, 3.0, 1.0).asDiagonal();
  s = make_drilling_system(s);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(s.dampers[k].axis_W, Vec3(Vec3::Unit(i)));
    EXPECT_EQ(s.dampers[k].coefficient, s.string.damping(i, i));
    EXPECT_EQ(s.turn_dampers[k].axis_W, Vec3(Vec3::Unit(i)));
    EXPECT_EQ(s.turn_dampers[k].coefficient, s.string.turn_damping(i, i));
  }
}

TEST(DrillingSystem, state_is_made_of_pose_and_velocities) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const Pose X_WB{Eigen::AngleAxisd(0.3, Vec3(0.6, 0.0, 0.8)).toRotationMatrix(), Vec3(1, 2, 3)};
  const DrillingVelocity v{Vec3(0.1, 0.2, 0.3), Vec3(-1.0, 2.0, 7.0), {4.0, -5.0}, 0.01};
  const DrillingState x = make_drilling_state(s, X_WB, v, std::vector<double>{0.5, 0.6});
  EXPECT_LT((bit_pose(s, x).R - X_WB.R).norm(), 1e-14);
  EXPECT_LT((bit_pose(s, x).p - X_WB.p).norm(), 1e-14);
  const DrillingVelocity found = velocity(s, x);
  EXPECT_LT((found.v_W - v.v_W).norm() + (found.w_W - v.w_W).norm(), 1e-13);
  EXPECT_NEAR(found.cone_rates[1], -5.0, 1e-13);
  EXPECT_NEAR(found.rock, 0.01, 1e-16);
  EXPECT_EQ(x.rotation.cone_angles[1], 0.6);
}

/// The moments are exactly proportional to the stiffness, however weak it is.
TEST(DrillingSystem, weak_string_turns_back_in_proportion) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const DrillingState x = coupled_start(s);
  Configuration strong, weak;
  configure(s, x, strong);
  s.string.turn_stiffness *= 0x1p-40;
  configure(s, x, weak);
  EXPECT_GT(strong.pull.turn_W.norm(), 1.0);
  EXPECT_EQ(weak.pull.turn_W, 0x1p-40 * strong.pull.turn_W);
  EXPECT_EQ(weak.pull.twist_moment, 0x1p-40 * strong.pull.twist_moment);
}

/// Upside down a string's angles are not defined; a bit that none turns back may pass there.
TEST(DrillingSystem, bit_without_stiffness_may_turn_over) {
  DrillingSystem s = plain_bit();
  s.string.turn_stiffness.setZero();
  DrillingState x = at_rest(s);
  x.rotation.q_WB = Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
  Configuration over;
  configure(s, x, over);
  EXPECT_EQ(over.pull.turn_W, Vec3::Zero());
  EXPECT_EQ(over.pull.twist_moment, 0.0);
  EXPECT_TRUE(std::isfinite(over.pull.energy));
}

/// The bit hangs still on a coupled string from the first step on.
TEST(DrillingSystem, string_hung_by_the_bits_weight_is_at_rest) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness = coupled(Vec3(4e5, 5e5, 7e5), 0.3);
  s = make_drilling_system(s);
  s.string.rest_W = hanging_rest_W(s, at_rest(s));
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 1000; ++i) step(s, nullptr, 1e-3, d);
  EXPECT_LT(d.state.c_W.norm(), 1e-15);
}

/// Everything at once, cones included: a thousand steps allocate nothing.
TEST(DrillingMemory, a_warm_step_allocates_nothing) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  Wrench wrench = d.wrench;
  const auto one = [&] {
    open_step(s, 1e-3, d, d.work);
    const DrillingState& there = predicted(s, 1e-3, d, d.work);
    wrench.force_W = -100.0 * there.momentum_W;
    close_step(s, 1e-3, wrench, d, d.work);
    return divergence(s, d, d.work).empty();
  };
  for (int i = 0; i < 3; ++i) one();
  battery::reset_peak();
  const long held = battery::counted_memory().held;
  bool sound = true;
  for (int i = 0; i < 1000; ++i) sound = sound && one();
  EXPECT_EQ(battery::counted_memory().peak, held);
  EXPECT_EQ(battery::counted_memory().held, held);
  EXPECT_TRUE(sound);
}

/// Bouncing in a hole of 1 mm with loss and friction, cones and string on. Forces jump where the
/// bit turns back, and no step control gets over a bit that stays there: the twin takes small equal
/// steps.
TEST(DrillingTwin, impacts_on_the_wall_are_followed) {
  DrillingSystem s = coupled_bit(AxialMode::load, DamperEnd::space);
  s.wall = {2e8, 1e-3, 0.1, -0.02, 0.7, 0.15, 0.05};
  s = make_drilling_system(s);
  DrillingState from = coupled_start(s);
  const Vec3 ring_B = Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B;
  from.c_W = -(from.rotation.q_WB * ring_B);  // the ring in the middle of the hole
  const reference::LumpedRun exact =
      reference::lumped_drilling_rk4(s, smooth_law, reference::lumped_state(s, from), 0.1, 20'000);
  constexpr double h = 2e-5;
  DrillingRun d = start(s, smooth_law, from);
  long impacts = 0;
  double depth = 0.0;
  for (int i = 0; i < 5'000; ++i) {
    step(s, smooth_law, h, d);
    if (depth == 0.0 && d.work.at.contact.depth > 0.0) ++impacts;
    depth = d.work.at.contact.depth;
  }
  EXPECT_GE(impacts, 4);
  EXPECT_LT((d.state.c_W - exact.state.c_W).norm(), 2e-6);
  EXPECT_NEAR(d.ledger.wall_loss, exact.energy.wall_loss, 9e-4 * exact.energy.wall_loss);
  EXPECT_NEAR(d.ledger.wall_friction, exact.energy.wall_friction,
              7e-4 * exact.energy.wall_friction);
}

/// Largest difference of two states, each quantity by its size in these problems.
double difference(const DrillingState& a, const DrillingState& b) {
  double worst = (a.c_W - b.c_W).norm() / 0.1;
  const auto take = [&](double x) { worst = std::max(worst, std::abs(x)); };
  take((a.momentum_W - b.momentum_W).norm() / 30.0);
  take((a.rotation.q_WB.toRotationMatrix() - b.rotation.q_WB.toRotationMatrix()).norm());
  take((a.rotation.momentum_W - b.rotation.momentum_W).norm() / 20.0);
  for (std::size_t k = 0; k < a.rotation.cone_momenta.size(); ++k) {
    take(a.rotation.cone_angles[k] - b.rotation.cone_angles[k]);
    take(a.rotation.cone_momenta[k] - b.rotation.cone_momenta[k]);
  }
  take((a.rock_z - b.rock_z) / 1e-3);
  take((a.rock_momentum - b.rock_momentum) / 0.2);
  return worst;
}

/// The same problem turned about space z. The bit's own frame turns along: its attitude is R times
/// what it was.
Mat3 turned(const Mat3& A, const Mat3& R) { return R * A * R.transpose(); }

DrillingSystem turned(DrillingSystem s, const Mat3& R) {
  s.string.rest_W = R * s.string.rest_W;
  s.string.stiffness = turned(s.string.stiffness, R);
  s.string.damping = turned(s.string.damping, R);
  s.string.turn_damping = turned(s.string.turn_damping, R);
  return make_drilling_system(s);
}

DrillingState turned(DrillingState x, const Mat3& R, double angle) {
  x.c_W = R * x.c_W;
  x.momentum_W = R * x.momentum_W;
  x.rotation.q_WB = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * x.rotation.q_WB;
  x.rotation.momentum_W = R * x.rotation.momentum_W;
  return x;
}

/// Resists alike in every direction across.
void round_law(const DrillingSystem&, const DrillingState& x, const DrillingVelocity& v,
               Wrench& w) {
  w.force_W = -80.0 * v.v_W.norm() * v.v_W - 4e3 * (x.c_W.z() + 0.2 - x.rock_z) * Vec3::UnitZ();
  w.torque_W = -3.0 * v.w_W;
  w.rock_force = -w.force_W.z();
}

/// To rounding. Dampers act one principal direction after another, so that a bit which couples
/// them knows the directions' order, by an error of the step's size; here nothing couples them.
RC_GTEST_PROP(DrillingSymmetry, nothing_changes_when_everything_turns_about_z, ()) {
  const double angle = *battery::number(-1.0, 1.0);
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string.attachment_B = s.centre_B;  // across, the string's damper is one number then
  s.string.damping = Vec3(200.0, 200.0, 900.0).asDiagonal();
  s.string.turn_damping = Vec3(0.0, 0.0, 9.0).asDiagonal();
  s.string.turn_stiffness = Vec3(2e3, 2e3, 0.0).asDiagonal();
  s = make_drilling_system(s);
  const DrillingSystem there = turned(s, R);
  DrillingRun a = start(s, round_law, coupled_start(s));
  DrillingRun b = start(there, round_law, turned(coupled_start(s), R, angle));
  for (int i = 0; i < 200; ++i) {
    step(s, round_law, 1e-3, a);
    step(there, round_law, 1e-3, b);
  }
  RC_ASSERT(difference(turned(a.state, R, angle), b.state) < 1.7e-12);
}

/// The step by -h undoes the step, dampers included: their flows are exact. A law of place alone;
/// friction, which forgets, and wall that loses are off.
TEST(DrillingSymmetry, step_back_undoes_the_step) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  s.wall.friction = 0.0;
  s = make_drilling_system(s);
  const LumpedLaw of_place = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    w.force_W.z() = -4e3 * std::pow(x.c_W.z() - x.rock_z + 0.2, 2);
    w.rock_force = -w.force_W.z();
  };
  const DrillingState from = coupled_start(s);
  DrillingRun d = start(s, of_place, from);
  for (int i = 0; i < 100; ++i) step(s, of_place, 1e-3, d);
  EXPECT_GT(difference(d.state, from), 0.1);
  for (int i = 0; i < 100; ++i) step(s, of_place, -1e-3, d);
  EXPECT_LT(difference(d.state, from), 1e-13);
}

TEST(DrillingSymmetry, a_resumed_run_is_bitwise_identical) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  DrillingRun through = start(s, smooth_law, coupled_start(s));
  for (int i = 0; i < 50; ++i) step(s, smooth_law, 1e-3, through);
  DrillingRun resumed = go_on(s, {through.state, through.wrench, through.ledger, {}});
  for (int i = 0; i < 50; ++i) {
    step(s, smooth_law, 1e-3, through);
    step(s, smooth_law, 1e-3, resumed);
  }
  EXPECT_EQ(difference(through.state, resumed.state), 0.0);
  EXPECT_EQ(residual(s, through), residual(s, resumed));
}

/// A drift that solves may be too long: the run stops with the state before the step.
TEST(DrillingSymmetry, a_drift_that_is_too_long_leaves_everything_as_it_was) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.integrator.drift = Drift::lie_midpoint;
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  step(s, smooth_law, 1e-3, d);
  const DrillingRun before = d;
  EXPECT_THROW(open_step(s, 5.0, d, d.work), RunError);
  EXPECT_EQ(difference(d.state, before.state), 0.0);
  EXPECT_EQ(d.state.rotation.time, before.state.rotation.time);
  EXPECT_EQ(residual(s, d), residual(s, before));
  step(s, smooth_law, 1e-3, d);  // a shorter one succeeds
  EXPECT_EQ(divergence(s, d, d.work), "");
}

/// Without string and rock the rotation is that of `tdbd rotate`, bit for bit, and the centre goes
/// straight on.
TEST(DrillingSymmetry, a_free_bit_turns_as_the_gyrostat_alone) {
  DrillingSystem s;
  s.mass = 100.0;
  s.gyrostat = coupled_bit(AxialMode::rate, DamperEnd::space).gyrostat;
  s = make_drilling_system(s);
  const DrillingState from = coupled_start(s);
  DrillingRun d = start(s, nullptr, from);
  Rotating alone = dynamics::start(s.gyrostat, Loads{}, from.rotation);
  for (int i = 0; i < 1000; ++i) {
    step(s, nullptr, 1e-3, d);
    dynamics::step(s.gyrostat, Loads{}, Integrator{}, 1e-3, alone);
  }
  EXPECT_EQ(d.state.rotation.q_WB.coeffs(), alone.state.q_WB.coeffs());
  EXPECT_EQ(d.state.rotation.cone_angles, alone.state.cone_angles);
  EXPECT_EQ(d.state.momentum_W, from.momentum_W);
  EXPECT_LT((d.state.c_W - from.c_W - from.momentum_W / s.mass).norm(), 1e-14);
}

/// A bit in a hole that it does not touch, on a slack string, feels nothing.
TEST(DrillingSymmetry, a_bit_that_touches_nothing_feels_nothing) {
  DrillingSystem s = plain_bit();
  s.wall = {1e9, 0.01, 0.1, 0.0, 0.5, 0.3, 1e-3};
  s.string.stiffness = (7e5 * Mat3::Identity()).eval();
  s.string.turn_stiffness = (900.0 * Mat3::Identity()).eval();
  s.string.damping = (1e4 * Mat3::Identity()).eval();
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, nullptr, 1e-3, d);
  EXPECT_EQ(d.state.c_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(d.state.momentum_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(d.state.rotation.momentum_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(residual(s, d), 0.0);
}

}  // namespace tdbd::dynamics::drilling_system_test

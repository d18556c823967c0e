#include "dynamics/rotation/step.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "core/error.hpp"
#include "dynamics/rotation/drift.hpp"
#include "verification/battery/dual.hpp"
#include "verification/battery/golden.hpp"

namespace tdbd::dynamics::step_test {

const battery::GoldenCase& top() {
  static const battery::GoldenCase c = battery::read_golden_case("slow_top");
  return c;
}

Rotating begin() { return start(top().gyrostat, top().loads, top().initial); }

void advance(const Integrator& integrator, double h, Rotating& r) {
  step(top().gyrostat, top().loads, integrator, h, r);
}

TEST(Step, evaluates_one_torque_a_stage) {
  for (const int order : composition_orders) {
    Rotating r = begin();
    const Integrator integrator{Drift::split, 2, order};
    for (int i = 0; i < 10; ++i) advance(integrator, 0.01, r);
    EXPECT_EQ(r.evaluations, 1 + 10 * static_cast<long>(composition(order).size()));
    EXPECT_NEAR(r.state.time, 0.1, 1e-15);
  }
}

TEST(Step, that_is_too_long_is_rejected_with_the_state_unchanged_and_a_suggested_step) {
  for (const Drift drift : {Drift::lie_midpoint, Drift::lie_mean}) {
    Rotating r = begin();
    for (int i = 0; i < 7; ++i) advance({drift}, 0.01, r);
    const Rotating before = r;
    std::string message;
    try {
      advance({drift}, 2.0, r);
    } catch (const RunError& e) {
      message = e.what();
    }
    EXPECT_EQ(r.state.q_WB.coeffs(), before.state.q_WB.coeffs());
    EXPECT_EQ(r.state.momentum_W, before.state.momentum_W);
    EXPECT_EQ(r.state.time, before.state.time);
    EXPECT_EQ(r.torque.total_W, before.torque.total_W);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(message, found, std::regex("a step of ([0-9.e-]+) s converges")))
        << message;
    const double would = std::strtod(found[1].str().c_str(), nullptr);
    EXPECT_THROW(advance({drift}, 2.0 * would, r), RunError);
    EXPECT_NO_THROW(advance({drift}, would, r));
  }
}

TEST(Step, explicit_drifts_take_any_step) {
  for (const Drift drift : {Drift::split, Drift::three_axis}) {
    Rotating r = begin();
    EXPECT_NO_THROW(advance({drift}, 2.0, r));
    EXPECT_TRUE(r.state.q_WB.coeffs().allFinite());
  }
}

TEST(Step, counts_the_windings_of_the_twist) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {});
  for (const int drifts : {1, 2, 3})
    for (const double speed : {5.0, -5.0}) {
      Rotating r = start(g, {}, make_state(g, Mat3::Identity(), Vec3(0.0, 0.0, speed), {}, {}));
      for (int i = 0; i < 1000; ++i) step(g, {}, {Drift::split, drifts}, 0.01, r);
      EXPECT_NEAR(rotation::twist_angle(r.state.q_WB, r.state.turns), 10.0 * speed, 1e-12);
    }
}

/// A body that turns about its axis needs no iteration: what ends the drift is the half turn.
Rotating turning_about_its_axis(const Gyrostat& g, const Loads& loads) {
  return start(g, loads, make_state(g, Mat3::Identity(), Vec3(0.0, 0.0, 1.0), {}, {}));
}

TEST(Step, drifts_that_solve_end_at_half_a_turn) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {});
  for (const Drift drift : {Drift::lie_midpoint, Drift::lie_mean}) {
    Rotating r = turning_about_its_axis(g, {});
    EXPECT_THROW(step(g, {}, {drift}, 3.2, r), RunError);
    EXPECT_NO_THROW(step(g, {}, {drift}, 3.1, r));
    EXPECT_NEAR(rotation::twist_angle(r.state.q_WB, r.state.turns), 3.1, 1e-14);
  }
}

TEST(Step, rejected_in_the_middle_of_a_composition_leaves_the_torque_as_it_was) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {});
  Loads loads;
  loads.harmonics.push_back({TorqueFrame::space, Vec3(0.0, 0.0, 1e-3), 0.1, 0.0});
  for (const Drift drift : {Drift::lie_midpoint, Drift::lie_mean}) {
    Rotating r = turning_about_its_axis(g, loads);
    const Rotating before = r;
    EXPECT_THROW(step(g, loads, {drift, 1, 4}, 6.0, r), RunError);  // the third stage is 3.9 s long
    EXPECT_GT(r.evaluations, before.evaluations);
    EXPECT_EQ(r.torque.total_W, before.torque.total_W);
    EXPECT_EQ(r.state.momentum_W, before.state.momentum_W);
    EXPECT_EQ(r.state.time, before.state.time);
  }
}

TEST(Step, the_message_names_the_drift_and_the_angle_of_the_step) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {});
  for (const auto& [drift, name] :
       {std::pair(Drift::lie_midpoint, "lie-midpoint"), std::pair(Drift::lie_mean, "lie-mean")}) {
    const std::string message =
        too_long_message(g, {}, {drift}, 4.0, turning_about_its_axis(g, {}));
    EXPECT_EQ(message, std::string("the ") + name +
                           " drift does not converge at t = 0 s with a step of 4 s (|W| h = 4 "
                           "rad); a step of 2 s converges");
  }
}

/// 2 s would do, 4 s would not: found by 60 halvings at the most.
TEST(Step, the_message_looks_for_a_step_by_60_halvings) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {});
  const Integrator integrator{Drift::lie_midpoint};
  const Rotating r = turning_about_its_axis(g, {});
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
  };
  for (const int halvings : {1, 30, 60})
    EXPECT_TRUE(ends_with(too_long_message(g, {}, integrator, std::ldexp(2.0, halvings), r),
                          "; a step of 2 s converges"))
        << halvings;
  EXPECT_TRUE(ends_with(too_long_message(g, {}, integrator, std::ldexp(2.0, 61), r),
                        "; no shorter step that converges was found"));
}

/// Halving the step divides the error at 1 s by 2^order; rounding is far below.
TEST(Step, composes_to_its_nominal_order) {
  const auto end = [](int order, int steps) {
    Rotating r = begin();
    for (int i = 0; i < steps; ++i) advance({Drift::split, 1, order}, 1.0 / steps, r);
    return r.state.momentum_W;
  };
  const Vec3 exact = end(8, 200);
  for (const int order : {4, 6, 8}) {
    const int steps = order == 8 ? 5 : 20;
    const double coarse = (end(order, steps) - exact).norm();
    const double fine = (end(order, 2 * steps) - exact).norm();
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.02) << order;
  }
}

TEST(Step, closes_with_the_torque_at_its_end) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {});
  Loads loads;
  loads.samples.push_back(
      {TorqueFrame::space, {0.0, 1.0}, {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 2.0)}});
  Rotating r = turning_about_its_axis(g, loads);
  const Vec3 before = r.state.momentum_W;
  step(g, loads, {}, 1.0, r);
  EXPECT_LE((r.state.momentum_W - before - Vec3(0.5, 0.0, 1.0)).norm(), 1e-15);
}

using Jet3 = battery::Dual<3>;

constexpr double rounding = 1e-13;  // momenta of order ten

Vec3 random_vector(double size) {
  const auto component = [size] { return size * 1e-4 * *rc::gen::inRange(-10'000, 10'001); };
  const double x = component(), y = component(), z = component();
  return {x, y, z};
}

Vec3Of<Jet3> seeded(const Vec3& v) {
  Vec3Of<Jet3> s;
  for (int i = 0; i < 3; ++i) {
    s[i] = Jet3(v[i]);
    s[i].by[i] = 1.0;
  }
  return s;
}

RC_GTEST_PROP(LieMomentum, slope_is_its_derivative_on_both_sides_of_the_series_end, ()) {
  const Vec3 T = random_vector(1.5), P = random_vector(5.0);
  const Vec3Of<Jet3> P_constant = P.cast<Jet3>();
  for (const LieMomentum which : {LieMomentum::middle, LieMomentum::mean}) {
    const LieTerm<double> term = lie_momentum<double>(which, T, P);
    const Vec3Of<Jet3> m = lie_momentum<Jet3>(which, seeded(T), P_constant).m;
    for (int i = 0; i < 3; ++i)
      RC_ASSERT((m[i].by.matrix().transpose() - term.by_T.row(i)).norm() <= rounding);
  }
}

/// The mean of exp(-s T) P by Gauss's rule, exact to rounding for angles up to three.
Vec3 mean_by_quadrature(const Vec3& T, const Vec3& P) {
  constexpr int intervals = 16;
  const double nodes[] = {-0.7745966692414834, 0.0, 0.7745966692414834};
  const double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < intervals; ++k)
    for (int n = 0; n < 3; ++n) {
      const double s = (k + 0.5 + 0.5 * nodes[n]) / intervals;
      sum += weights[n] / intervals * (rotation::quaternion_exp<double>(-s * T) * P);
    }
  return sum;
}

RC_GTEST_PROP(LieMomentum, is_that_of_the_middle_or_the_mean_of_the_way, ()) {
  const Vec3 T = random_vector(1.5), P = random_vector(5.0);
  const Vec3 middle = rotation::quaternion_exp<double>(-0.5 * T) * P;
  constexpr double quadrature = 2.8e-11;
  RC_ASSERT((lie_momentum<double>(LieMomentum::middle, T, P).m - middle).norm() <= rounding);
  RC_ASSERT((lie_momentum<double>(LieMomentum::mean, T, P).m - mean_by_quadrature(T, P)).norm() <=
            quadrature);
}

TEST(SolveLie, carries_derivatives_that_solve_the_equation_too) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {});
  const Vec3Of<Jet3> P = seeded(Vec3(1.5, -2.0, 3.0)), none = Vec3Of<Jet3>::Zero();
  constexpr double h = 0.3;
  for (const LieMomentum which : {LieMomentum::middle, LieMomentum::mean}) {
    Vec3Of<Jet3> T;
    ASSERT_EQ(solve_lie<Jet3>(g, which, h, P, none, {}, T), LieOutcome::solved);
    const Vec3Of<Jet3> residual =
        g.carrier_B.cast<Jet3>() * T - h * lie_momentum<Jet3>(which, T, P).m;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(residual[i].value, 0.0, rounding);
      EXPECT_LE(residual[i].by.matrix().norm(), rounding);
    }
  }
}

}  // namespace tdbd::dynamics::step_test

namespace tdbd::dynamics::kick_test {

constexpr double rounding = 1e-14;

/// A body with one cone, damped about every axis and in the bearing.
struct Damped {
  Gyrostat g = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {{Vec3(0.6, 0.0, 0.8), 0.1}});
  Loads loads;
  Rotating r;

  explicit Damped(double damping) {
    loads.damping_W = damping * Vec3::Ones();
    loads.cones.push_back({.internal = 0.0, .external = 0.0, .damping = 0.01 * damping});
    const double spin[] = {-6.0}, angle[] = {0.0};
    r.state = make_state(g, Mat3::Identity(), Vec3(1.0, -2.0, 3.0), spin, angle);
    evaluate(g, loads, r.state, r.torque);
  }
};

TEST(SymmetricKick, is_undone_by_the_opening_kick_of_the_step_back) {
  Damped d(0.5);
  const RotationState before = d.r.state;
  implicit_kick(d.g, d.loads, 0.05, d.r);
  EXPECT_GT((d.r.state.momentum_W - before.momentum_W).norm(), 0.01);
  kick(-0.05, d.r.torque, d.r.state);
  EXPECT_LE((d.r.state.momentum_W - before.momentum_W).norm(), rounding);
  EXPECT_NEAR(d.r.state.cone_momenta[0], before.cone_momenta[0], rounding);
}

TEST(SymmetricKick, counts_its_evaluations) {
  Damped d(0.5);
  d.r.evaluations = 1;
  implicit_kick(d.g, d.loads, 0.05, d.r);
  EXPECT_GE(d.r.evaluations, 3);
  EXPECT_LE(d.r.evaluations, 25);
}

TEST(SymmetricKick, reports_damping_that_is_too_strong_for_the_step) {
  Damped d(500.0);
  EXPECT_THROW(implicit_kick(d.g, d.loads, 0.05, d.r), RunError);
}

TEST(MomentumDifference, watches_the_cones_too) {
  const Damped d(0.5);
  RotationState other = d.r.state;
  other.cone_momenta[0] += 1e-3;
  EXPECT_GT(momentum_difference(d.r.state, other), 1e-9);
}

}  // namespace tdbd::dynamics::kick_test

#include "dynamics/rotation/step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "core/error.hpp"
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

TEST(Step, that_is_too_long_is_refused_with_the_state_as_it_was_and_the_step_that_would_do) {
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
    ASSERT_TRUE(std::regex_search(message, found, std::regex("a step of ([0-9.e-]+) s would")))
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

TEST(Step, refused_in_the_middle_of_a_composition_leaves_the_torque_as_it_was) {
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
                           "rad); a step of 2 s would");
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
                          "; a step of 2 s would"))
        << halvings;
  EXPECT_TRUE(ends_with(too_long_message(g, {}, integrator, std::ldexp(2.0, 61), r),
                        "; no shorter one was found that would"));
}

/// Halving the step divides the error at 1 s by 2^order; rounding is far below.
TEST(Step, composes_to_the_order_it_says) {
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

}  // namespace tdbd::dynamics::step_test

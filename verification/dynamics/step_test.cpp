#include "dynamics/step.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "core/error.hpp"
#include "verification/battery/golden.hpp"

namespace tdbd::dynamics {
namespace {

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
    EXPECT_LT(would, 2.0);
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
  for (const double speed : {5.0, -5.0}) {
    Rotating r = start(g, {}, make_state(g, Mat3::Identity(), Vec3(0.0, 0.0, speed), {}, {}));
    for (int i = 0; i < 1000; ++i) step(g, {}, {}, 0.01, r);
    EXPECT_NEAR(rotation::twist_angle(r.state.q_WB, r.state.turns), 10.0 * speed, 1e-11);
  }
}

}  // namespace
}  // namespace tdbd::dynamics

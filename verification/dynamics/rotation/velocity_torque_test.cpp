#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/observed_order.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/rotation_checks.hpp"

namespace tdbd::battery::velocity_torque_test {

using dynamics::Drift;
using dynamics::Integrator;
using dynamics::VelocityTorque;

constexpr double end = 2.0;             ///< s
constexpr double second_order = 0.004;  ///< how far a slope may be from 2

/// Unequal cones under gravity, with dampers in space and in the bearings.
GoldenCase damped() {
  GoldenCase c = read_golden_case("heavy_gyro_phys");
  c.loads.damping_W = Vec3(0.3, 0.2, 0.4);
  for (dynamics::ConeLoad& l : c.loads.cones) l.damping = 0.02;
  return c;
}

/// Order of each variable over seven levels, against the eighth-order symmetric composition.
std::vector<double> orders(const RotationScheme& scheme, long coarsest) {
  const GoldenCase c = damped();
  const RotationScheme best =
      production("best", Integrator{Drift::split, 1, 8, VelocityTorque::symmetric});
  const dynamics::RotationState reference = carry(best, c, end / 400.0, 400).state;
  std::vector<double> steps;
  std::array<std::vector<double>, state_variables.size()> errors;
  for (long n = coarsest; n <= 64 * coarsest; n *= 2) {
    const double h = end / static_cast<double>(n);
    const StateErrors e = state_errors(carry(scheme, c, h, n).state, reference);
    steps.push_back(h);
    for (std::size_t v = 0; v < e.size(); ++v) errors[v].push_back(e[v]);
  }
  std::vector<double> found;
  for (const std::vector<double>& e : errors) found.push_back(least_squares_order(steps, e));
  return found;
}

TEST(VelocityTorque, predicted_closing_torque_is_second_order_at_one_evaluation) {
  for (const Drift drift :
       {Drift::split, Drift::three_axis, Drift::lie_midpoint, Drift::lie_mean}) {
    double worst = 0.0;
    for (const double order : orders(production("predicted", Integrator{drift}), 100)) {
      EXPECT_NEAR(order, 2.0, second_order);
      worst = std::max(worst, std::abs(order - 2.0));
    }
    if (drift != Drift::split) continue;
    record({"chapter5/velocity-torque",
            "split, torque at the predicted momentum: largest deviation of an order from 2", worst,
            "1", fmt::format("<= {}", second_order),
            worst <= second_order ? Verdict::holds : Verdict::refuted});
  }
  dynamics::Rotating r = carry(production("", Integrator{}), damped(), 0.01, 50);
  EXPECT_EQ(r.evaluations, 51);
}

/// What the thesis's wording alone would give: the torque of the last evaluation, as it stands.
RotationScheme kept_torque() {
  const auto step = [](const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                       auto& r) {
    dynamics::kick(0.5 * h, r.torque, r.state);
    dynamics::drift_split(g, h, r.state);
    r.state.time += h;
    dynamics::evaluate(g, loads, r.state, r.torque);
    dynamics::kick(0.5 * h, r.torque, r.state);
  };
  return {"kept torque", 2, step, step, step};
}

TEST(VelocityTorque, torque_at_the_momentum_as_it_stands_is_first_order) {
  const std::vector<double> found = orders(kept_torque(), 100);
  for (const double order : found) EXPECT_NEAR(order, 1.0, 0.05);
  record({"chapter5/velocity-torque",
          "torque evaluated at the drifted momentum: order of the attitude", found.front(), "1",
          "2 would be second order", Verdict::refuted});
}

TEST(VelocityTorque, symmetric_closing_torque_composes_to_order_4) {
  const RotationScheme scheme =
      production("symmetric", Integrator{Drift::split, 1, 4, VelocityTorque::symmetric});
  for (const double order : orders(scheme, 8)) EXPECT_NEAR(order, 4.0, 0.05);
}

}  // namespace tdbd::battery::velocity_torque_test

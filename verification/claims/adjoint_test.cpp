#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/evidence.hpp"
#include "claims/carry.hpp"
#include "core/observed_order.hpp"
#include "reference/dynamics/adjoint_maps.hpp"

namespace tdbd::claims::adjoint_test {

/// Rounding of 200 steps; scale: 1 rad, 1 N m s (momenta here are below 20).
constexpr double reversible = 2e-14;
constexpr double h = 0.01;  // s
constexpr long steps = 100;

double distance(const dynamics::RotationState& a, const dynamics::RotationState& b) {
  double d = attitude_error(a.q_WB.toRotationMatrix(), b.q_WB.toRotationMatrix());
  d = std::max(d, (a.momentum_W - b.momentum_W).norm());
  for (std::size_t k = 0; k < a.cone_angles.size(); ++k)
    d = std::max({d, std::abs(a.cone_angles[k] - b.cone_angles[k]),
                  std::abs(a.cone_momenta[k] - b.cone_momenta[k])});
  return d;
}

/// There with h and back with -h.
double defect(const battery::GoldenCase& c) {
  const auto there = carry(c.gyrostat, c.loads, thesis, c.initial, h, steps);
  const auto back = carry(c.gyrostat, c.loads, thesis, there.state, -h, steps);
  return distance(back.state, c.initial);
}

TEST(AdjointComposition, the_thesis_step_of_minus_h_undoes_the_step_of_h) {
  double worst = 0.0;
  for (const std::string& name : battery::golden_names()) {
    const double found = defect(battery::read_golden_case(name));
    EXPECT_LE(found, reversible) << name;
    worst = std::max(worst, found);
  }
  battery::record(
      {"chapter5/adjoint-composition",
       fmt::format("thesis drift: distance from the start after {} steps of {} s and as "
                   "many of {} s, worst of nine golden cases",
                   steps, h, -h),
       worst, "rad, N m s", fmt::format("<= {}", reversible),
       worst <= reversible ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// The check finds a step that is not its own adjoint: one with the first kick alone.
TEST(AdjointComposition, is_not_found_in_a_step_of_first_order) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  auto r = dynamics::start(c.gyrostat, c.loads, c.initial);
  for (const double sign : {1.0, -1.0})
    for (long i = 0; i < steps; ++i) {
      dynamics::kick(sign * h, r.torque, r.state);
      dynamics::coast(c.gyrostat, thesis.drift, thesis.drifts_per_step, sign * h, r.state);
      dynamics::evaluate(c.gyrostat, c.loads, r.state, r.torque);
    }
  EXPECT_GT(distance(r.state, c.initial), 1e6 * reversible);
}

using reference::GyrostatState;
using Map = GyrostatState (*)(const dynamics::Gyrostat&, const dynamics::Loads&, double,
                              const GyrostatState&);

double distance(const GyrostatState& a, const GyrostatState& b) {
  double d =
      std::max(attitude_error(a.R_WB, b.R_WB), (a.body_momentum_B - b.body_momentum_B).norm());
  for (std::size_t k = 0; k < a.cone_angles.size(); ++k)
    d = std::max({d, std::abs(a.cone_angles[k] - b.cone_angles[k]),
                  std::abs(a.cone_momenta[k] - b.cone_momenta[k])});
  return d;
}

/// One undoes the other taken backward, from states all along the golden motions.
TEST(AdjointComposition, of_two_maps_of_which_one_undoes_the_other_taken_backward) {
  constexpr double rounding = 4e-14;  // momenta are below 20
  double worst = 0.0;
  for (const std::string& name : battery::golden_names()) {
    const battery::GoldenCase c = battery::read_golden_case(name);
    GyrostatState s = reference::matrix_state(c.initial);
    for (int i = 0; i < 50; ++i) {
      const GyrostatState back = reference::impulse_first(c.gyrostat, c.loads, -h, s);
      worst = std::max(worst, distance(reference::impulse_last(c.gyrostat, c.loads, h, back), s));
      s = reference::impulse_first(c.gyrostat, c.loads, h, s);
    }
  }
  EXPECT_LE(worst, rounding);
  battery::record({"chapter5/adjoint-composition",
                   fmt::format("impulse at the end of {0} s after impulse at the start of {1} s: "
                               "distance from the state, worst of nine golden cases",
                               h, -h),
                   worst, "rad, N m s", fmt::format("<= {}", rounding),
                   worst <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// Half a step of each is the program's step in the thesis's form.
TEST(AdjointComposition, of_half_steps_of_both_is_the_thesis_step) {
  constexpr double rounding = 2e-13;  // of 100 steps, scale as above
  double worst = 0.0;
  for (const std::string& name : battery::golden_names()) {
    const battery::GoldenCase c = battery::read_golden_case(name);
    GyrostatState s = reference::matrix_state(c.initial);
    for (long i = 0; i < steps; ++i)
      s = reference::impulse_last(c.gyrostat, c.loads, 0.5 * h,
                                  reference::impulse_first(c.gyrostat, c.loads, 0.5 * h, s));
    const auto program = carry(c.gyrostat, c.loads, thesis, c.initial, h, steps);
    worst = std::max(worst, distance(s, reference::matrix_state(program.state)));
  }
  EXPECT_LE(worst, rounding);
  battery::record({"chapter5/adjoint-composition",
                   fmt::format("half steps of both maps against the program's step, {} steps of {} "
                               "s, worst of nine golden cases",
                               steps, h),
                   worst, "rad, N m s", fmt::format("<= {}", rounding),
                   worst <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// Errors after a second against the golden state: attitude, momentum, cones' angles and momenta.
std::vector<double> errors_of(Map map, const battery::GoldenCase& c, int count) {
  GyrostatState s = reference::matrix_state(c.initial);
  for (int i = 0; i < count; ++i) s = map(c.gyrostat, c.loads, 1.0 / count, s);
  const battery::GoldenState& exact = c.states.at(1);
  std::vector<double> errors{attitude_error(s.R_WB, exact.R_WB),
                             (s.body_momentum_B - exact.body_momentum_B).norm(), 0.0, 0.0};
  for (std::size_t k = 0; k < s.cone_angles.size(); ++k) {
    errors[2] = std::max(errors[2], std::abs(s.cone_angles[k] - exact.cone_angles[k]));
    errors[3] = std::max(errors[3], std::abs(s.cone_momenta[k] - exact.cone_momenta[k]));
  }
  return errors;
}

/// Each map alone is of first order in every variable, where a torque bends the motion.
TEST(AdjointComposition, of_maps_that_are_each_of_first_order) {
  constexpr double within = 0.06, at_rounding = 1e-11;
  double worst = 0.0;
  int orders = 0;
  for (const std::string& name : battery::golden_names()) {
    const battery::GoldenCase c = battery::read_golden_case(name);
    if (c.loads.gravity_moment == 0.0 && c.loads.body_torque_B.isZero()) continue;
    for (const Map map : {&reference::impulse_first, &reference::impulse_last}) {
      std::vector<double> sizes;
      std::vector<std::vector<double>> errors(4);
      for (int count = 800; count <= 12'800; count *= 2) {
        sizes.push_back(1.0 / count);
        const std::vector<double> found = errors_of(map, c, count);
        for (std::size_t v = 0; v < 4; ++v) errors[v].push_back(found[v]);
      }
      for (const std::vector<double>& of_variable : errors) {
        if (of_variable.back() < at_rounding) continue;  // no torque on it, or no cones
        const double order = least_squares_order(sizes, of_variable);
        EXPECT_NEAR(order, 1.0, within) << name;
        worst = std::max(worst, std::abs(order - 1.0));
        ++orders;
      }
    }
  }
  EXPECT_GE(orders, 8);
  battery::record({"chapter5/adjoint-composition",
                   "order of either map alone, golden cases with a torque, every variable: largest "
                   "deviation from 1",
                   worst, "1", fmt::format("<= {}", within),
                   worst <= within ? battery::Verdict::holds : battery::Verdict::refuted});
}

}  // namespace tdbd::claims::adjoint_test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/evidence.hpp"
#include "claims/carry.hpp"

namespace tdbd::claims::adjoint_test {

/// Rounding of 200 steps; scale: 1 rad, 1 N m s (momenta here are below 20).
constexpr double reversible = 1e-12;
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

}  // namespace tdbd::claims::adjoint_test

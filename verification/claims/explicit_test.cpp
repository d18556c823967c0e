#include <fmt/format.h>
#include <gtest/gtest.h>

#include "battery/evidence.hpp"
#include "claims/carry.hpp"

namespace tdbd::claims::explicit_test {

constexpr double h = 0.01;  // s
constexpr long steps = 1000;

/// Evaluations a step, without the one that opens the first.
double evaluations_a_step(const battery::GoldenCase& c) {
  const auto end = carry(c.gyrostat, c.loads, thesis, c.initial, h, steps);
  return static_cast<double>(end.evaluations - 1) / static_cast<double>(steps);
}

void check(const std::string& what, battery::GoldenCase c) {
  const double found = evaluations_a_step(c);
  EXPECT_EQ(found, 1.0) << what;
  battery::record(
      {"chapter5/explicit",
       fmt::format("thesis drift, {}: torque evaluations a step, over {} steps", what, steps),
       found, "1", "1", found == 1.0 ? battery::Verdict::holds : battery::Verdict::refuted});
}

TEST(Explicitness, the_thesis_step_evaluates_the_torque_once) {
  check("heavy body with three cones", battery::read_golden_case("heavy_gyro_phys"));
}

TEST(Explicitness, also_when_the_torque_depends_on_velocity) {
  battery::GoldenCase c = battery::read_golden_case("heavy_gyro_phys");
  c.loads.damping_W = Vec3(0.1, 0.2, 0.3);
  check("heavy body with three cones and dampers", c);
}

/// What stays implicit in the form as reconstructed is the drift, which no torque enters: too long
/// a drift of a free body does not solve.
TEST(Explicitness, does_not_reach_the_drift_which_solves) {
  battery::GoldenCase c = battery::read_golden_case("gyro_free_asym_phys");
  constexpr double longest = 4.0;  // s
  double too_long = h;
  const auto solves = [&c](double step) {
    dynamics::RotationState s = c.initial;
    return dynamics::coast(c.gyrostat, thesis.drift, 1, step, s) == dynamics::LieOutcome::solved;
  };
  while (too_long < longest && solves(too_long)) too_long *= 1.1;
  EXPECT_LT(too_long, longest);
  battery::record(
      {"chapter5/explicit",
       "thesis drift, free body with three cones: length of a drift from which on its "
       "equation (three unknowns, no torque in it) finds no solution",
       too_long, "s", "none, were the drift explicit too",
       too_long < longest ? battery::Verdict::holds_with_limits : battery::Verdict::holds});
}

}  // namespace tdbd::claims::explicit_test

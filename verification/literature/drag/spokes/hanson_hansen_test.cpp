#include "reference/literature/drag/spokes/hanson_hansen.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/literature/drag/spokes/rk4.hpp"
#include "verification/battery/evidence.hpp"

namespace tdbd::reference::hanson_hansen_test {
namespace {

/// A bit that flies at 0.1 m/s against free rock through a spring of 8.6e6 N/m, until the spring is left, or to the
/// time given.
struct Collision {
  HansonHansenState state{};
  double contact = 0.0;   ///< s
  double momentum = 0.0;  ///< N s
};

Collision collide(RockSign sign, double end) {
  constexpr double stiffness = 8.6e6, h = 1e-6;
  DrillStringAndRock s;
  s.mass = 500.0;
  s.rock_mass = 280.0;
  s.sign = sign;
  Collision c;
  c.state[5] = 0.1;
  for (double t = 0.0; t < end; t += h) {
    rk4_step(
        [&](double time, const HansonHansenState& y, HansonHansenState& rates) {
          rates = {};
          HansonHansenLoad load;
          load.force_W.z() = -stiffness * std::max(0.0, place_in_rock(y).p_WB.z());
          string_and_rock_rates(s, time, y, load, rates);
        },
        t, h, c.state);
    if (place_in_rock(c.state).p_WB.z() > 0.0) c.contact += h;
  }
  c.momentum = axial_momentum(s, c.state);
  return c;
}

/// The pair's reduced mass and the elastic collision's speeds are in every textbook.
TEST(HansonHansen, keeps_the_momentum_of_bit_and_rock_when_the_rock_feels_the_opposite_force) {
  const Collision c = collide(RockSign::newton, 0.02);
  const double lost = std::abs(c.momentum - 50.0);
  constexpr double rounding = 1e-12;  // N s
  EXPECT_LE(lost, rounding);
  battery::record({"chapter2/rock-sign",
                   "momentum of 50 N s that is lost when a bit of 500 kg meets free rock of 280 "
                   "kg, the rock feeling "
                   "-fz",
                   lost, "N s", fmt::format("<= {}", rounding),
                   lost <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
  EXPECT_NEAR(c.state[5], 0.028205, 1e-6);
  EXPECT_NEAR(c.state[9], 0.128205, 1e-6);
  EXPECT_NEAR(c.state[5], 0.1 * (500.0 - 280.0) / 780.0, 1e-6);
  const double contact = std::numbers::pi * std::sqrt(500.0 * 280.0 / 780.0 / 8.6e6);
  EXPECT_NEAR(contact, 14.352e-3, 1e-6);
  EXPECT_NEAR(c.contact, contact, 3e-6);  // three steps
}

TEST(HansonHansen, makes_momentum_of_nothing_with_the_sign_as_extracted) {
  const double momentum = collide(RockSign::as_extracted, 0.2).momentum;
  EXPECT_LT(momentum, -1e11);  // printed: -8e11 N s
  EXPECT_NEAR(momentum / -8e11, 1.0, 0.1);
  battery::record(
      {"chapter2/rock-sign",
       "momentum of the same pair 0.2 s later with +fz, the sign of our copy without minus signs",
       momentum, "N s", "is not 50",
       std::abs(momentum - 50.0) > 1.0 ? battery::Verdict::holds : battery::Verdict::refuted});
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_test

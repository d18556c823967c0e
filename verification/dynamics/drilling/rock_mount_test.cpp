#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "verification/battery/evidence.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

namespace tdbd::dynamics::rock_mount_test {

constexpr double contact = 8.6e6;  ///< N/m

/// Elastic contact along z between the bit and the rock where it is now.
void elastic_contact(const DrillingSystem&, const DrillingState& s, const DrillingVelocity&,
                     Wrench& w) {
  w.force_W.z() = -contact * std::max(s.c_W.z() - s.rock_z, 0.0);
  w.rock_force = -w.force_W.z();
}

/// Worked example: a bit of 500 kg at 0.1 m/s meets free rock of 280 kg.
TEST(RockMount, action_equals_reaction_on_free_rock) {
  DrillingSystem s = plain_bit();
  s.rock.mass = 280.0;
  s = make_drilling_system(s);
  DrillingState start_state = at_rest(s);
  start_state.momentum_W.z() = 50.0;
  DrillingRun d = start(s, elastic_contact, start_state);
  constexpr double h = 1e-5;
  double contact_time = 0.0, worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    step(s, elastic_contact, h, d);
    if (d.wrench.rock_force > 0.0) contact_time += h;
    worst = std::max(worst, std::abs(d.state.momentum_W.z() + d.state.rock_momentum - 50.0));
  }
  constexpr double rounding = 1e-12;  // N s
  EXPECT_LE(worst, rounding);
  battery::record({"chapter2/moving-rock",
                   "momentum of bit and free rock, 50 N s, over an impact: largest change", worst,
                   "N s", fmt::format("<= {}", rounding),
                   worst <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
  EXPECT_NEAR(d.state.momentum_W.z() / s.mass, 0.1 * (500.0 - 280.0) / 780.0, 4e-8);
  EXPECT_NEAR(d.state.rock_momentum / s.rock.mass, 0.1 * 1000.0 / 780.0, 7.5e-8);
  const double reduced_mass = s.mass * s.rock.mass / (s.mass + s.rock.mass);
  EXPECT_NEAR(contact_time, std::numbers::pi * std::sqrt(reduced_mass / contact), 0.6 * h);
}

TEST(RockMount, held_rock_does_not_move) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingState start_state = at_rest(s);
  start_state.momentum_W.z() = 50.0;
  DrillingRun d = start(s, elastic_contact, start_state);
  for (int i = 0; i < 5000; ++i) step(s, elastic_contact, 1e-5, d);
  EXPECT_EQ(d.state.rock_z, 0.0);
  EXPECT_EQ(d.state.rock_momentum, 0.0);
  EXPECT_NEAR(d.state.momentum_W.z(), -50.0, 3e-5);  // it bounces back
}

}  // namespace tdbd::dynamics::rock_mount_test

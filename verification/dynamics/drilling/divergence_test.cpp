#include "dynamics/drilling/divergence.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::divergence_test {

TEST(Divergence, a_sound_run_has_none) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  EXPECT_EQ(divergence(s, d, d.work), "");
  for (int i = 0; i < 1000; ++i) {
    step(s, smooth_law, 1e-3, d);
    ASSERT_EQ(divergence(s, d, d.work), "");
  }
}

TEST(Divergence, names_the_force_that_is_no_number) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const LumpedLaw broken = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    if (x.rotation.time > 0.0095) w.force_W.y() = std::numeric_limits<double>::quiet_NaN();
  };
  DrillingRun d = start(s, broken, coupled_start(s));
  int steps = 0;
  while (divergence(s, d, d.work).empty() && ++steps < 100) step(s, broken, 1e-3, d);
  EXPECT_EQ(steps, 10);
  EXPECT_EQ(divergence(s, d, d.work), "the force of cutting is not finite at t = 0.01 s");
}

/// A spring far beyond the stability limit: the run ends with the motion that ran away.
TEST(Divergence, names_the_motion_that_runs_away) {
  DrillingSystem s = plain_bit();
  s.string.stiffness.diagonal() = Vec3(0.0, 0.0, 5e9);
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W.z() = 1.0;
  DrillingRun d = start(s, nullptr, from);
  for (int i = 0; i < 100 && divergence(s, d, d.work).empty(); ++i) step(s, nullptr, 1e-3, d);
  EXPECT_EQ(divergence(s, d, d.work).find("the residual of energy"), 0U)
      << divergence(s, d, d.work);
  d.ledger.start = 1e30;  // as if there had been so much to begin with
  while (divergence(s, d, d.work).empty()) step(s, nullptr, 1e-3, d);
  EXPECT_NE(divergence(s, d, d.work).find("the bit's speed along z"), std::string::npos);
}

/// A force law that feeds energy, which no ledger explains, is caught before speeds are absurd.
TEST(Divergence, sees_energy_from_nowhere) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingRun d = start(s, nullptr, at_rest(s));
  d.state.momentum_W.z() += 500.0;
  step(s, nullptr, 1e-3, d);
  EXPECT_EQ(divergence(s, d, d.work),
            "the residual of energy: 250 J where 0 J came and went, most of it in the bit's "
            "translation at t = 0.001 s");
}

/// What came and went is the sum of all ways, of whatever sign.
TEST(Divergence, measures_the_residual_by_every_way_in_and_out) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingRun d = start(s, nullptr, at_rest(s));
  const auto told = [&](double EnergyLedger::*a, double EnergyLedger::*b) {
    d.ledger = {};
    d.ledger.wall_loss = 1000.0;  // which nothing explains
    d.ledger.*a = 3.0;
    d.ledger.*b = 4.0;
    const std::string why = divergence(s, d, d.work);
    return why.substr(0, why.find(" came"));
  };
  using L = EnergyLedger;
  constexpr std::array ways{&L::start, &L::top, &L::gravity, &L::cut_bit, &L::cut_rock};
  for (const auto a : ways)
    for (const auto b : ways) {
      if (a == b) continue;
      EXPECT_NE(told(a, b).find(" where 7 J"), std::string::npos) << told(a, b);
    }
}

}  // namespace tdbd::dynamics::divergence_test

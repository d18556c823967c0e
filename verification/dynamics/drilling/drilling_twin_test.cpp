#include <gtest/gtest.h>

#include "reference/dynamics/lumped_drilling.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_twin_test {

/// Bouncing in a hole of 1 mm with loss and friction, cones and string on. Forces jump where the
/// bit turns back, and no step control gets over a bit that stays there: the twin takes small equal
/// steps.
TEST(DrillingTwin, impacts_on_the_wall_are_followed) {
  DrillingSystem s = coupled_bit(AxialMode::load, DamperEnd::space);
  s.wall = {2e8, 1e-3, 0.1, -0.02, 0.7, 0.15, 0.05};
  s = make_drilling_system(s);
  DrillingState from = coupled_start(s);
  const Vec3 ring_B = Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B;
  from.c_W = -(from.rotation.q_WB * ring_B);  // the ring in the middle of the hole
  const reference::LumpedRun exact =
      reference::lumped_drilling_rk4(s, smooth_law, reference::lumped_state(s, from), 0.1, 20'000);
  constexpr double h = 2e-5;
  DrillingRun d = start(s, smooth_law, from);
  long impacts = 0;
  double depth = 0.0;
  for (int i = 0; i < 5'000; ++i) {
    step(s, smooth_law, h, d);
    if (depth == 0.0 && d.work.at.contact.depth > 0.0) ++impacts;
    depth = d.work.at.contact.depth;
  }
  EXPECT_GE(impacts, 4);
  EXPECT_LT((d.state.c_W - exact.state.c_W).norm(), 2e-6);
  EXPECT_NEAR(d.ledger.wall_loss, exact.energy.wall_loss, 9e-4 * exact.energy.wall_loss);
  EXPECT_NEAR(d.ledger.wall_friction, exact.energy.wall_friction,
              7e-4 * exact.energy.wall_friction);
}

}  // namespace tdbd::dynamics::drilling_twin_test

#include "reference/literature/drag/spokes/spoke_loads.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace tdbd::reference::spoke_loads_test {
namespace {

constexpr double step = 1e-3;  // s
const SpokeLoad pressing{{30.0, 40.0, -100.0}, -7.0, 1.5 * step};

/// Of one cutter, which crosses in the middle of the first step.
std::vector<NeededLoad> spread_over(int steps) {
  SpokeLoads loads = spoke_loads(1, step);
  std::vector<NeededLoad> found;
  for (int k = 0; k < steps; ++k) {
    begin_step(loads);
    if (k == 0) cross(loads, 0, 0.5 * step, pressing);
    end_step(loads);
    found.push_back(loads.spread);
  }
  return found;
}

TEST(SpokeLoads, count_for_their_own_time_and_no_longer) {
  const auto found = spread_over(4);
  const double shares[] = {0.5, 1.0, 0.0, 0.0};
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].wob, 100.0 * shares[k], 1e-12) << k;
    EXPECT_NEAR(found[k].tob, 7.0 * shares[k], 1e-12) << k;
  }
}

TEST(SpokeLoads, are_held_for_ever_or_act_in_one_step_for_comparison) {
  SpokeLoads loads = spoke_loads(2, step);
  begin_step(loads);
  cross(loads, 1, 0.5 * step, pressing);
  end_step(loads);
  EXPECT_NEAR(loads.by_step.wob, 150.0, 1e-12);
  EXPECT_NEAR(lateral_size(loads), 25.0, 1e-12);
  for (int k = 0; k < 9; ++k) begin_step(loads), end_step(loads);
  EXPECT_EQ(held_load(loads).wob, 100.0);
  EXPECT_EQ(held_load(loads).tob, 7.0);
  EXPECT_EQ(loads.by_step.wob, 0.0);
}

/// From 0 to `most`.
double some(double most) { return most * *rc::gen::inRange(0, 100001) / 100000.0; }

/// However early the next crossing comes, what is left of the last counts then.
RC_GTEST_PROP(SpokeLoads, lose_no_impulse, ()) {
  SpokeLoads loads = spoke_loads(1, step);
  double spread = 0.0, by_step = 0.0, impulse = 0.0;
  const int steps = *rc::gen::inRange(0, 20);
  for (int k = 0; k < steps; ++k) {
    SpokeLoad load = pressing;
    load.time = some(5.0 * step);
    begin_step(loads);
    cross(loads, 0, some(step), load);
    end_step(loads);
    impulse += 100.0 * load.time;
    spread += loads.spread.wob * step;
    by_step += loads.by_step.wob * step;
  }
  spread += 100.0 * loads.last[0].time;
  RC_ASSERT(std::abs(spread - impulse) <= 1e-12 * (1.0 + impulse));
  RC_ASSERT(std::abs(by_step - impulse) <= 1e-12 * (1.0 + impulse));
}

}  // namespace
}  // namespace tdbd::reference::spoke_loads_test

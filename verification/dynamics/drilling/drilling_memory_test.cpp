#include <gtest/gtest.h>

#include "dynamics/drilling/divergence.hpp"
#include "verification/battery/counted_memory.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_memory_test {

/// Everything at once, cones included: a thousand steps allocate nothing.
TEST(DrillingMemory, a_warm_step_allocates_nothing) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  Wrench wrench = d.wrench;
  const auto one = [&] {
    open_step(s, 1e-3, d, d.work);
    const DrillingState& there = predicted(s, 1e-3, d, d.work);
    wrench.force_W = -100.0 * there.momentum_W;
    close_step(s, 1e-3, wrench, d, d.work);
    return divergence(s, d, d.work).empty();
  };
  for (int i = 0; i < 3; ++i) one();
  battery::reset_peak();
  const long held = battery::counted_memory().held;
  bool sound = true;
  for (int i = 0; i < 1000; ++i) sound = sound && one();
  EXPECT_EQ(battery::counted_memory().peak, held);
  EXPECT_EQ(battery::counted_memory().held, held);
  EXPECT_TRUE(sound);
}

}  // namespace tdbd::dynamics::drilling_memory_test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "battery/counted_memory.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::memory_test {

using battery::counted_memory;

TEST(Memory, counts_allocated_bytes_and_their_maximum) {
  const long before = counted_memory().held;
  battery::reset_peak();
  { const std::vector<char> room(1'000'000); }
  EXPECT_EQ(counted_memory().held, before);
  EXPECT_GE(counted_memory().peak, before + 1'000'000);
  EXPECT_LE(counted_memory().peak, before + 1'010'000);
}

/// The rock, its index and all room that steps keep, over the rock's triangles. The bit, which does
/// not grow with the rock, is not counted.
TEST(Memory, a_rock_takes_at_most_250_bytes_a_triangle) {
  constexpr double bytes_a_triangle = 250.0;  // required
  const Case c =
      read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml", {"maintenance.renumber_every=50"});
  const rock::CuttingBit bit = rock::prepare_cutting_bit(c.bit);
  const long before = counted_memory().held;
  const rock::CuttingBit once_more = bit;
  const long of_the_bit = counted_memory().held - before;
  battery::reset_peak();
  Simulation s = start(c);
  const double start_peak = static_cast<double>(counted_memory().peak - before - 2 * of_the_bit);
  for (int i = 0; i < 100; ++i) step(c, s);
  const auto triangles = static_cast<double>(s.state.rock.surface.triangle_count());
  const double held = static_cast<double>(counted_memory().held - before - 2 * of_the_bit);
  fmt::print("{} triangles: {:.0f} bytes a triangle, {:.0f} at most while the start is built\n",
             s.state.rock.surface.triangle_count(), held / triangles, start_peak / triangles);
  EXPECT_LE(held / triangles, bytes_a_triangle);
}

/// What a warm step takes beyond what is held, bytes: the least of some steps, since rooms grow now
/// and then with the wall.
long taken_by_a_step(const std::string& name, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"rock.edge_length='4 mm'", "maintenance.every=0"});
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", more);
  Simulation s = start(c);
  for (int i = 0; i < 50; ++i) step(c, s);
  long least = counted_memory().held;
  for (int i = 0; i < 20; ++i) {
    battery::reset_peak();
    const long before = counted_memory().held;
    step(c, s);
    least = std::min(least, counted_memory().peak - before);
  }
  return least;
}

TEST(Memory, a_step_with_forces_allocates_nothing_once_warm) {
  EXPECT_EQ(taken_by_a_step("bit-b-3000psi"), 0);
  EXPECT_EQ(taken_by_a_step("drill-bit-b"), 0);
}

TEST(Memory, a_step_that_renumbers_the_rock_allocates_nothing_once_warm) {
  EXPECT_EQ(taken_by_a_step("bit-b-3000psi", {"maintenance.renumber_every=1"}), 0);
}

TEST(Memory, a_step_of_a_bit_at_rest_allocates_nothing_once_warm) {
  EXPECT_EQ(
      taken_by_a_step("stick-slip", {"motion.rotary_speed='0 rpm'", "motion.torque_at_start=0"}),
      0);
}

}  // namespace tdbd::simulation::memory_test

#include "reference/literature/drag/spokes/langeveld_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

namespace tdbd::reference::langeveld_path_test {
namespace {

constexpr double pi = std::numbers::pi, turn_rate = 4.0 * pi;  // 120 rpm
constexpr double advance = 3e-3, reach = 107.95e-3;
constexpr DragRock rock_k{100e6, 0.8, 0.0, 0.0};

std::vector<bit::Cutter> example(const std::string& letter) {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/bit-" + letter + ".csv",
                                bit::CutterDefaults{});
}

LangeveldDrilling drilling() {
  LangeveldDrilling d;
  d.rotary_speed = turn_rate;
  d.advance = advance;
  return d;
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// Nodes at cell centres over 0 to R sum to the whole disc, but for rims that end between two nodes.
TEST(LangeveldPath, removes_the_whole_disc_in_a_turn_with_the_torque_of_its_energy) {
  constexpr double tolerance = 2e-4;  // of each; seen: up to 1.2e-5
  for (const char* letter : {"a", "b", "c"}) {
    const PathRun run = langeveld_steady(example(letter), rock_k, drilling());
    const double torque = rock_k.specific_energy * reach * reach * advance / 2.0;
    EXPECT_NEAR(sum(run.area) / (reach * advance), 1.0, tolerance) << letter;
    EXPECT_NEAR(sum(run.volume) / (pi * reach * reach * advance), 1.0, tolerance) << letter;
    EXPECT_NEAR(run.tob / torque, 1.0, tolerance) << letter;
  }
}

/// One radial plane in fine columns is what locked spokes of 500 nodes must find, but for the node at
/// which the rims of two cutters of the gage end.
TEST(LangeveldPath, cuts_what_the_radial_plane_says_when_it_cannot_move_sideways) {
  for (const char* letter : {"a", "b", "c"}) {
    const auto cutters = example(letter);
    const PathRun run = langeveld_steady(cutters, rock_k, drilling());
    const PlanarCut plane = planar_cut(cutters, advance, 0.01e-3);
    const double one_node = reach / 500 * advance;  // m2; seen: 0.82 of it
    for (std::size_t i = 0; i < cutters.size(); ++i)
      EXPECT_NEAR(run.area[i], plane.area[i], 0.005 * plane.area[i] + one_node)
          << letter << " cutter " << cutters[i].id;
  }
}

/// Spread of a series about its mean, over that mean, in groups of steps.
double noise(const std::vector<double>& series, std::size_t first, std::size_t group) {
  double sum = 0.0, squares = 0.0;
  std::size_t groups = 0;
  for (std::size_t i = first; i + group <= series.size(); i += group, ++groups) {
    double mean = 0.0;
    for (std::size_t j = i; j < i + group; ++j) mean += series[j] / static_cast<double>(group);
    sum += mean, squares += mean * mean;
  }
  const double mean = sum / static_cast<double>(groups);
  return std::sqrt(squares / static_cast<double>(groups) - mean * mean) / mean;
}

/// A force that acts in the step of its crossing makes the torque rough where the held one is smooth (1 ms, bit A).
TEST(LangeveldPath, is_rough_where_forces_act_in_the_step_of_a_crossing) {
  for (const auto& [spokes, by_step, by_five] :
       {std::tuple(120, 0.23, 0.049), std::tuple(72, 0.26, 0.064), std::tuple(360, 0.067, 0.011)}) {
    LangeveldDrilling d = drilling();
    d.layout.spokes = spokes;
    const PathRun run = langeveld_steady(example("a"), rock_k, d);
    EXPECT_NEAR(noise(run.tob_by_step, 1000, 1), by_step, 0.01 * by_step) << spokes;
    EXPECT_NEAR(noise(run.tob_by_step, 1000, 5), by_five, 0.03 * by_five) << spokes;
    const auto [least, most] =
        std::ranges::minmax_element(run.tob_held.begin() + 1000, run.tob_held.end());
    EXPECT_LT(*most - *least, 1e-6 * *most) << spokes;
  }
}

/// A bit that rolls backwards on its hole: of the crossings of 72 planes by bit B 23.6 % are against the rotation.
TEST(LangeveldPath, sees_cutters_go_backwards_in_whirl) {
  const auto rims = spoke_cutters(example("b"), "Langeveld");
  LangeveldRock rock = fitting_rock(rims, 0.0, -0.06, 72, 500, 115e-3);
  const PathRun run =
      langeveld_path(rims, rock_k, rock, whirl_path({reach, 1.5e-3, turn_rate}, advance),
                     {1.0, 2e-5}, {CountedRock::within_rim});
  EXPECT_NEAR(run.backwards, 0.236, 0.005);  // seen: 0.2348
  EXPECT_GT(run.lowered, 0.9 * pi * reach * reach * advance);
  EXPECT_LT(run.lowered, 1.1 * pi * reach * reach * advance);
}

TEST(LangeveldPath, wants_cutters) {
  try {
    langeveld_steady({}, rock_k, drilling());
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("Langeveld: ", 0), 0u);
  }
}

}  // namespace
}  // namespace tdbd::reference::langeveld_path_test

#include "reference/literature/drag/langeveld_path.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/planar_outline.hpp"

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

TEST(LangeveldPath, wants_cutters) {
  try {
    langeveld_steady({}, rock_k, {});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("Langeveld: ", 0), 0u);
  }
}

}  // namespace
}  // namespace tdbd::reference::langeveld_path_test

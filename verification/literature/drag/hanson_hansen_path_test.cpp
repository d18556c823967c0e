#include "reference/literature/drag/hanson_hansen_path.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/langeveld_rock.hpp"
#include "reference/literature/drag/planar_outline.hpp"

namespace tdbd::reference::hanson_hansen_path_test {
namespace {

constexpr double pi = std::numbers::pi, turn_rate = 4.0 * pi;  // 120 rpm
constexpr double advance = 3e-3, reach = 107.95e-3;

HansonHansenRock rock_k() {
  HansonHansenRock rock;
  rock.shared = {100e6, 0.8, 0.0, 0.0};
  return rock;
}

HansonHansenDrilling drilling(int spokes) {
  HansonHansenDrilling d;
  d.rotary_speed = turn_rate;
  d.advance = advance;
  d.layout.spokes = spokes;
  return d;
}

std::vector<bit::Cutter> example(const std::string& letter) {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/bit-" + letter + ".csv",
                                bit::CutterDefaults{});
}

/// Every spoke sees the same passes, so few of them show the means. The cutters of the gage stand beside a wall: of
/// them a pass takes less than 2 mm2 that is all edge, and there the two surfaces differ.
TEST(HansonHansenPath, cuts_what_the_radial_plane_says_when_it_cannot_move_sideways) {
  constexpr double beside_wall = 0.075e-6;  // m2; seen: 0.061e-6 (bit A, cutter 35)
  for (const char* letter : {"a", "b", "c"}) {
    const auto cutters = example(letter);
    const PathRun run = hanson_hansen_steady(cutters, rock_k(), drilling(12));
    const PlanarCut plane = planar_cut(cutters, advance, 0.01e-3);
    for (std::size_t i = 0; i < cutters.size(); ++i) {
      if (cutters[i].tip_radius < 5e-3) continue;
      EXPECT_NEAR(run.area[i], plane.area[i], 0.01 * plane.area[i] + beside_wall)
          << letter << " cutter " << cutters[i].id;
    }
  }
}

TEST(HansonHansenPath, asks_the_torque_of_the_energy_of_a_whole_disc) {
  const double torque = 100e6 * reach * reach * advance / 2.0;
  for (const char* letter : {"a", "b"}) {
    const PathRun run = hanson_hansen_steady(example(letter), rock_k(), drilling(12));
    EXPECT_NEAR(run.tob / torque, 1.0, 0.002) << letter;  // seen: 1.1e-3
  }
}

/// 50 mm below the top of an upright wall a cutter goes half into it.
TEST(HansonHansenPath, takes_a_half_disc_out_of_a_wall_where_a_height_field_takes_a_column) {
  constexpr double a = 6.7e-3, wall = 0.1, down = 50e-3, mm2 = 1e-6;
  const SpokeRim rim{wall, down, a, 0.0, a};
  OutlineSpokes several = flat_outline_spokes({0.2, 0.2}, 0.0, 1, 0.2e-3);
  cut_spoke(several, 0, {{0.0, -0.01}, {wall, -0.01}, {wall, 0.19}, {0.0, 0.19}});
  LangeveldRock one;
  one.bottom = flat_spokes(0.2, 0.0, 1, 200000);
  one.wall = round_wall(1, wall);
  for (int j = 0; j < one.bottom.nodes; ++j)
    if (one.bottom.node_radius(j) < wall) one.bottom.depth[at(j)] = 0.19;
  const double section = cut_outline(several, 0, rim).area, column = cut_rock(one, 0, rim).lowered;
  EXPECT_NEAR(section / mm2, 70.513, 0.002 * 70.513);      // a polygon of 64 corners: 0.16 % less
  EXPECT_NEAR(column / mm2, 370.257, 1e-5 * 370.257);      // nodes of 1 um
  EXPECT_NEAR(rim_in_rock(one, 0, rim).area, 0.0, 1e-12);  // it is gone
}

TEST(HansonHansenPath, wants_cutters) {
  try {
    hanson_hansen_steady({}, rock_k(), drilling(12));
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("Hanson and Hansen: ", 0), 0u);
  }
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_path_test

#include "reference/literature/drag/spokes/hanson_hansen_path.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"
#include "reference/literature/drag/spokes/langeveld_rock.hpp"
#include "verification/battery/evidence.hpp"

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

/// Every spoke sees the same passes, so few of them show the means. The cutters of the gage stand beside a wall that
/// hangs over between their passes: there the two surfaces differ, whatever the nodes and the corners of rims.
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
  for (const char* letter : {"a", "b", "c"}) {
    const PathRun run = hanson_hansen_steady(example(letter), rock_k(), drilling(12));
    EXPECT_NEAR(run.tob / torque, 1.0, 0.0015)
        << letter;  // seen: 5.2e-4; nodes 0.5 mm apart: 2.4e-3
  }
}

/// 50 mm below the top of an upright wall a cutter goes half into it.
TEST(HansonHansenPath, takes_a_half_disc_out_of_a_wall_where_a_height_field_takes_a_column) {
  constexpr double a = 6.7e-3, wall = 0.1, down = 50e-3, mm2 = 1e-6;
  const RimEllipse rim{wall, down, a, a, 0.0};
  OutlineSpokes several = flat_outline_spokes({0.2, 0.2}, 0.0, 1, 0.2e-3);
  cut_spoke(several, 0, {{0.0, -0.01}, {wall, -0.01}, {wall, 0.19}, {0.0, 0.19}});
  LangeveldRock one;
  one.bottom = flat_spokes(0.2, 0.0, 1, 200000);
  one.wall = round_wall(1, wall);
  for (int j = 0; j < one.bottom.nodes; ++j)
    if (one.bottom.node_radius(j) < wall) one.bottom.depth[at(j)] = 0.19;
  EXPECT_NEAR(rim_in_rock(one, 0, rim, CountedRock::within_rim).area / mm2, 70.513, 1e-4 * 70.513);
  const double section = cut_outline(several, 0, rim).area, column = cut_rock(one, 0, rim).lowered;
  EXPECT_NEAR(section / mm2, 70.513, 0.002 * 70.513);      // a polygon of 64 corners: 0.16 % less
  EXPECT_NEAR(column / mm2, 370.257, 1e-5 * 370.257);      // nodes of 1 um
  EXPECT_NEAR(rim_in_rock(one, 0, rim).area, 0.0, 1e-12);  // it is gone
  battery::record({"chapter2/undercut",
                   "what a spoke of one depth for each radius loses to a half disc of 6.7 mm 50 mm "
                   "below the top of "
                   "a wall, over what one of several loses",
                   column / section, "1", "5.25 +- 0.02",
                   std::abs(column / section - 5.25) <= 0.02 ? battery::Verdict::holds
                                                             : battery::Verdict::refuted});
}

/// Led backwards around its hole, bit B leaves a star: it removes more than its own disc and less than the hole's, or
/// a little less than its own where cusps hang over.
TEST(HansonHansenPath, follows_a_prescribed_whirl) {
  const double orbit = 3e-3, disc = pi * reach * reach * advance,
               hole = pi * (reach + orbit) * (reach + orbit) * advance;
  const auto rims = spoke_cutters(example("b"), "Hanson and Hansen");
  HansonHansenLayout layout;
  layout.spokes = 72;
  OutlineSpokes rock = fitting_outline_rock(rims, 0.02, layout);
  const PathRun run = hanson_hansen_path(
      rims, rock_k(), rock, whirl_path({reach, orbit, turn_rate}, advance), {1.5, 5e-5});
  double removed = 0.0;
  for (const double v : run.volume) removed += v;
  EXPECT_GT(removed, 0.98 * disc);
  EXPECT_LT(removed, hole);
  EXPECT_NEAR(run.backwards, 0.239, 0.005);
}

std::string complaint(const std::vector<bit::Cutter>& cutters, const HansonHansenDrilling& d) {
  try {
    hanson_hansen_steady(cutters, rock_k(), d);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(HansonHansenPath, says_what_it_needs) {
  EXPECT_EQ(complaint({}, drilling(12)),
            "Hanson and Hansen: found a bit without cutters; needs a table of PDC cutters");
  HansonHansenDrilling still = drilling(12), deep = drilling(12);
  still.rotary_speed = 0.0;
  deep.revolutions = 1000.0;
  EXPECT_EQ(complaint(example("a"), still),
            "Hanson and Hansen: needs a rotary speed above 0 rad/s");
  EXPECT_EQ(complaint(example("a"), deep).rfind("Hanson and Hansen: found 3.000000 m to drill", 0),
            0u);
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_path_test

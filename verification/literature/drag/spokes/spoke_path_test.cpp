#include "reference/literature/drag/spokes/spoke_path.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "battery/evidence.hpp"
#include "literature/drag/planes/behr_runs.hpp"
#include "reference/literature/drag/spokes/langeveld_path.hpp"

/// How long the force of a crossing counts, drilling steadily and in whirl.
namespace tdbd::reference::spoke_path_test {
namespace {

constexpr double turn = 2.0 * std::numbers::pi / example_speed;  // s
constexpr double shift = 1.5e-3;                                 // m, of the bit in its hole
constexpr double short_step = 1e-4;                              // s; an orbit takes 6.9 ms
const RollingWhirl rolling{example_gage, shift, example_speed};

PathRun steady() {
  LangeveldDrilling d;
  d.rotary_speed = example_speed;
  d.advance = example_advance;
  return langeveld_steady(example_cutters('b'), rock_k(), d);
}

/// In the first turn the bottom that fits the bit at rest becomes that of the bit that drills.
TEST(SpokePath, has_one_load_in_steady_drilling_however_long_a_crossing_counts) {
  constexpr double rounding = 1e-12;  // of each; seen: 3.9e-13
  constexpr std::size_t first = 505;
  const PathRun run = steady();
  for (std::size_t i = first; i < run.wob_held.size(); ++i) {
    EXPECT_NEAR(run.wob_spread[i] / run.wob_held[i], 1.0, rounding) << i;
    EXPECT_NEAR(run.tob_spread[i] / run.tob_held[i], 1.0, rounding) << i;
  }
  EXPECT_NEAR(run.wob / run.wob_held.back(), 1.0, rounding);
  EXPECT_NEAR(run.tob / run.tob_held.back(), 1.0, rounding);
  EXPECT_NEAR(run.side / run.lateral_B.norm(), 1.0, rounding);
}

/// What a cutter does whose back goes first. Behr's rubs, which in this rock takes no force.
enum class Back { cuts, slides };

/// Five turns of bit B, which rolls backwards on its hole, on Langeveld's spokes.
PathRun whirl(int spokes, Back back, CountedRock counted) {
  const auto rims = spoke_cutters(example_cutters('b'), "Langeveld");
  constexpr double top = -0.06;  // m
  LangeveldRock rock = fitting_rock(rims, 0.0, top, spokes, 500, rolling.hole_radius());
  const PathModel model{spokes,
                        [&](std::size_t, int spoke, const PlacedCutter& c) {
                          return cut_rock(rock, spoke, c.rim, counted);
                        },
                        [&](std::size_t, const CrossingCut& cut, const Vec3& normal_W,
                            const Vec3& face_W, const Vec3& v_W) -> Vec3 {
                          if (back == Back::slides && v_W.dot(face_W) <= 0.0) return Vec3::Zero();
                          return area_force(rock_k(), cut.area, normal_W, v_W);
                        }};
  return follow(whirl_path(rolling, example_advance), rims, model, {5.0 * turn, short_step});
}

/// The same law on the same planes, and the same rock that counts: all above a rim.
TEST(SpokePath, of_a_whirl_asks_for_the_loads_of_behrs_planes) {
  constexpr double weights = 0.006, torques = 0.002;  // of each; seen: 0.0028, 0.0008
  for (const int planes : {72, 120}) {
    const PathRun run = whirl(planes, Back::slides, CountedRock::all_above);
    const BehrRun behr = whirl_turn(shift, planes).run;
    EXPECT_NEAR(run.wob / mean(behr.weight), 1.0, weights) << planes;
    EXPECT_NEAR(run.tob / mean(behr.torque), 1.0, torques) << planes;
  }
}

/// Langeveld's law as the comparison has it knows no backs: a cutter that goes backwards takes weight, and gives
/// torque. A rim's own section is less than the column above it.
TEST(SpokePath, of_a_whirl_differs_from_behrs_by_the_law_for_backs_and_the_rock_that_counts) {
  constexpr double room = 0.0015;  // seen: 0.0005
  const BehrRun behr = whirl_turn(shift, 72).run;
  const PathRun run = whirl(72, Back::cuts, CountedRock::within_rim);
  EXPECT_NEAR(run.wob / mean(behr.weight), 1.069, room);
  EXPECT_NEAR(run.tob / mean(behr.torque), 0.912, room);
  const PathRun sliding = whirl(72, Back::slides, CountedRock::within_rim);
  EXPECT_NEAR(sliding.tob / mean(behr.torque), 0.976, room);
}

/// Mean of the last turn of five.
double last_turn(const std::vector<double>& series) {
  const auto count = static_cast<std::ptrdiff_t>(series.size() / 5);
  return mean({series.end() - count, series.end()});
}

TEST(SpokePath, of_a_whirl_asks_for_far_too_much_if_forces_are_held) {
  for (const auto& [spokes, ratio, room] :
       {std::tuple(72, 1.72, 0.0045), std::tuple(120, 1.63, 0.0016)}) {
    const PathRun run = whirl(spokes, Back::cuts, CountedRock::within_rim);
    const double found = last_turn(run.wob_held) / run.wob;
    EXPECT_NEAR(found, ratio, room) << spokes;
    battery::record(
        {"chapter2/held-forces",
         "mean weight with forces held to the next crossing over that with each counted for its "
         "own time, bit B rolling backwards at 3 mm a revolution in a hole larger by 1.5 mm all "
         "round, " +
             std::to_string(spokes) + " spokes of Langeveld's",
         found, "1", fmt::format("{:g} +- {:g}", ratio, room),
         std::abs(found - ratio) <= room ? battery::Verdict::holds : battery::Verdict::refuted});
  }
}

/// A force in the step of its crossing has the impulse of one that is spread, but for what the ends of the turn cut.
TEST(SpokePath, has_the_same_impulse_in_one_step_as_spread) {
  constexpr double ends = 0.005;  // seen: 0.0017
  const PathRun run = whirl(72, Back::cuts, CountedRock::within_rim);
  EXPECT_NEAR(last_turn(run.wob_by_step) / last_turn(run.wob_spread), 1.0, ends);
  EXPECT_NEAR(last_turn(run.tob_by_step) / last_turn(run.tob_spread), 1.0, ends);
  EXPECT_NEAR(last_turn(run.wob_spread) / run.wob, 1.0, 1e-9);
}

/// In whirl the level force turns against the bit, so that its mean says nothing about its size.
TEST(SpokePath, of_a_whirl_has_a_level_force_far_larger_than_its_mean) {
  const PathRun run = whirl(72, Back::cuts, CountedRock::within_rim);
  EXPECT_GT(run.side, 20.0 * run.lateral_B.norm());  // seen: 45 times
  EXPECT_GT(run.side, run.wob);
}

}  // namespace
}  // namespace tdbd::reference::spoke_path_test

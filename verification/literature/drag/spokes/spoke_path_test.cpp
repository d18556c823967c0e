#include "reference/literature/drag/spokes/spoke_path.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "battery/evidence.hpp"
#include "literature/drag/planes/behr_runs.hpp"
#include "reference/literature/drag/spokes/langeveld_path.hpp"
#include "reference/literature/drag/spokes/outline_cut.hpp"
#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/drag/spokes/spoke_loads.hpp"
#include "reference/literature/drag/spokes/spoke_wall.hpp"
#include "reference/literature/surface/planar_boolean.hpp"

/// How long the force of a crossing counts, drilling steadily and in whirl.
namespace tdbd::reference::spoke_path_test {

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
TEST(SpokePath, of_a_whirl_needs_the_loads_of_behrs_planes) {
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

TEST(SpokePath, of_a_whirl_needs_far_too_much_if_forces_are_constant) {
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

/// In whirl the horizontal force turns against the bit, so that its mean is no measure of its size.
TEST(SpokePath, of_a_whirl_has_a_level_force_far_larger_than_its_mean) {
  const PathRun run = whirl(72, Back::cuts, CountedRock::within_rim);
  EXPECT_GT(run.side, 20.0 * run.lateral_B.norm());  // seen: 45 times
  EXPECT_GT(run.side, run.wob);
}

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
  EXPECT_EQ(last_loads(loads).wob, 100.0);
  EXPECT_EQ(last_loads(loads).tob, 7.0);
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

/// A mass against the spring by velocity Verlet in steps of 10 us, as the worked number was made.
struct Impact {
  double deepest = 0.0, strongest = 0.0, contact = 0.0, speed_out = 0.0;
};

Impact impact(double mass, const WallSpring& spring, double speed) {
  constexpr double h = 1e-5;
  double p = 0.0, v = speed;
  Impact found;
  do {
    v -= h / 2.0 * spring_force(spring, p, v) / mass;
    p += h * v;
    const double force = spring_force(spring, p, v);
    found.deepest = std::max(found.deepest, p);
    found.strongest = std::max(found.strongest, force);
    v -= h / 2.0 * force / mass;
    found.contact += h;
  } while (p > 0.0);
  found.speed_out = -v;
  return found;
}

TEST(SpokeWall, throws_a_bit_back_with_less_speed) {
  constexpr double mass = 500.0, k = 1e8, e = 0.6, v = 0.1;
  const double w0 = std::sqrt(k / mass), deepest = v / w0;
  EXPECT_NEAR(deepest, 0.223607e-3, 1e-9);
  EXPECT_NEAR(k * deepest, 22360.68, 0.01);
  const double contact = std::numbers::pi / 2.0 * (1.0 + 1.0 / e) / w0;
  EXPECT_NEAR(contact, 9.36642e-3, 1e-8);
  EXPECT_NEAR(0.5 * mass * v * v * (1.0 - e * e), 1.600, 1e-12);
  const Impact found = impact(mass, {k, e}, v);
  EXPECT_NEAR(found.deepest / deepest, 1.0, 1e-5);
  EXPECT_NEAR(found.strongest / (k * deepest), 1.0, 1e-5);
  EXPECT_NEAR(found.contact, contact, 2e-5);  // two steps
  EXPECT_NEAR(found.speed_out, 0.0600, 1e-6);
}

TEST(SpokeWall, keeps_the_energy_of_a_bit_when_it_restores_all) {
  EXPECT_NEAR(impact(500.0, {1e8, 1.0}, 0.1).speed_out, 0.1, 1e-6);
}

constexpr double mm = 1e-3;
const SpokeFrame frame{100 * mm, 60 * mm};

/// An integer share of a range, so that shrinking works.
double in_range(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 100001) / 100000.0;
}

RimEllipse any_rim() {
  return {in_range(-4 * mm, 100 * mm), in_range(-8 * mm, 20 * mm), in_range(2 * mm, 9 * mm),
          in_range(2 * mm, 9 * mm), in_range(-1.0, 1.0)};
}

Outline tool_of(const RimEllipse& rim) {
  Outline tool;
  outline_of(rim_polygon(rim), tool);
  for (Vec2& x : tool) x = on_grid(x);
  return tool;
}

/// Many passes in one spoke: booleans of all, against crossings where there are two.
RC_GTEST_PROP(OutlineCut, leaves_what_booleans_leave, ()) {
  OutlineSpokes quick = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  PlanarRegion slow = quick.rock;
  const int passes = *rc::gen::inRange(1, 12);
  for (int pass = 0; pass < passes; ++pass) {
    const Outline tool = tool_of(any_rim());
    PlanarFace face = quick.rock.front();
    const double before = area({face});
    const double removed = before - area(without({face}, tool));
    if (cut_between_two_crossings(face, tool))
      RC_ASSERT(std::abs(before - area({face}) - removed) < 1e-10);  // m2: 2 nm along the rim
    cut_convex(quick, 0, tool);
  }
}

RC_GTEST_PROP(RimInFace, is_the_area_and_moment_of_the_common_part, ()) {
  OutlineSpokes rock = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  const int passes = *rc::gen::inRange(0, 8);
  for (int pass = 0; pass < passes; ++pass) cut_convex(rock, 0, tool_of(any_rim()));
  const RimEllipse rim = any_rim();
  const CrossingCut cut = rim_in_face(rim_polygon(rim), rock.rock.front());
  const PlanarRegion common = within(rock.rock, tool_of(rim));
  RC_ASSERT(std::abs(cut.area - area(common)) < 1e-10);  // m2: corners on the grid of 1 nm
  RC_ASSERT(std::abs(cut.moment - moment(common)) < 1e-11);
}

/// A rim whose middle is on a flat surface: its whole lower branch is in rock, and half of its area.
TEST(RimInFace, measures_the_edge_in_rock) {
  const OutlineSpokes rock = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  const double a = 8 * mm;
  const CrossingCut half = rim_in_face(rim_polygon({50 * mm, 0.0, a, a, 0.0}), rock.rock.front());
  EXPECT_NEAR(half.edge, M_PI * a, 5e-4 * M_PI * a);  // 32 chords: 4e-4 less
  EXPECT_NEAR(half.area, M_PI * a * a / 2.0, 2e-3 * half.area);
  EXPECT_NEAR(half.moment / half.area, 50 * mm, 1e-12);
}

}  // namespace tdbd::reference::spoke_path_test

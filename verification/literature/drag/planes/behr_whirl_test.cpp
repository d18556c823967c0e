#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/evidence.hpp"
#include "literature/drag/planes/behr_runs.hpp"

/// What planes do not see: the pattern of a whirling bit, and the way from one plane to the next.
namespace tdbd::reference::behr_whirl_test {
namespace {

constexpr double pi = std::numbers::pi, mm = 1e-3;
using Lobes = std::vector<int>;

void record_lobes(const std::string& what, const FifthTurn& turn, int expected) {
  const int found = strongest(near_the_gage(turn), 1).front();
  EXPECT_EQ(found, expected) << what;
  battery::record({"chapter2/whirl-aliases", what, static_cast<double>(found), "1",
                   std::to_string(expected),
                   found == expected ? battery::Verdict::holds : battery::Verdict::refuted});
}

std::string lobes_on(int planes, const std::string& hole) {
  return "strongest harmonic of the bottom at r = 100 mm, bit B rolling backwards at 3 mm a "
         "revolution in a hole larger by " +
         hole + " all round, " + std::to_string(planes) + " planes";
}

/// A rolling gage touches the wall again 2 pi e further on: Rh/e = 72.97 lobes, of which planes
/// every 5 degrees show one. The second number is the fourth harmonic's alias, and so on.
TEST(WhirlPattern, of_73_lobes_is_one_lobe_on_72_planes) {
  const FifthTurn coarse = whirl_turn(1.5 * mm, 72), fine = whirl_turn(1.5 * mm, 720);
  EXPECT_EQ(strongest(near_the_gage(fine), 4), (Lobes{73, 146, 74, 219}));
  EXPECT_EQ(strongest(near_the_gage(coarse), 4), (Lobes{1, 3, 4, 2}));
  record_lobes(lobes_on(720, "1.5 mm"), fine, 73);
  record_lobes(lobes_on(72, "1.5 mm"), coarse, 1);
  const RollingWhirl whirl{example_gage, 1.5 * mm, example_speed};
  EXPECT_NEAR(whirl.lobes(), 72.97, 0.005);
}

/// Rh/e = 36.98: three times that is 111, on 72 planes 111 - 2 x 72 = -33.
TEST(WhirlPattern, of_37_lobes_is_33_on_72_planes) {
  const FifthTurn coarse = whirl_turn(3 * mm, 72), fine = whirl_turn(3 * mm, 720);
  EXPECT_EQ(strongest(near_the_gage(fine), 3), (Lobes{111, 74, 36}));
  EXPECT_EQ(strongest(near_the_gage(coarse), 3), (Lobes{33, 2, 31}));
  record_lobes(lobes_on(720, "3 mm"), fine, 111);
  record_lobes(lobes_on(72, "3 mm"), coarse, 33);
  EXPECT_NEAR(near_the_gage(coarse).peak_to_peak, 8.12 * mm, 0.812 * mm);
  EXPECT_NEAR(near_the_gage(fine).peak_to_peak, 10.67 * mm, 1.067 * mm);
}

/// The star's crests are missed by a quarter of their height.
TEST(WhirlPattern, is_lower_on_fewer_planes) {
  struct Row {
    int planes;
    double height;  // mm
  };
  for (const Row& row : {Row{72, 4.91}, {120, 5.83}, {720, 6.64}})
    EXPECT_NEAR(near_the_gage(whirl_turn(1.5 * mm, row.planes)).peak_to_peak, row.height * mm,
                0.1 * row.height * mm)
        << row.planes;
}

/// 120 spokes see up to 60 lobes: the hole of an 8.5 in bit must be larger by Rh/60 = 1.8 mm.
TEST(WhirlPattern, of_more_lobes_than_half_the_spokes_is_lost) {
  const double least = example_gage / 59;  // Rh/e = 60 with Rh = Rb + e
  EXPECT_NEAR(least, 1.8 * mm, 0.05 * mm);
  EXPECT_NEAR((RollingWhirl{example_gage, least, 1.0}.lobes()), 60.0, 1e-9);
}

/// Between the discs of bit and hole: the hole is a star. Without whirl, the bit's disc.
TEST(WhirlVolume, lies_between_those_of_bit_and_hole) {
  const double Rb = example_gage, Rh = Rb + 1.5 * mm;
  BehrOptions options;
  options.radius = Rb;
  const double still =
      fifth_turn('b', steady_path(example_speed, example_advance), options).run.removed();
  constexpr double crossing = 3e-5;  // one at the turn's very end may count in the next turn
  EXPECT_NEAR(still, pi * Rb * Rb * example_advance, crossing * still);
  EXPECT_NEAR(still, 109971e-9, 0.01 * still);
  for (const int planes : {72, 120, 720}) {
    const FifthTurn turn = whirl_turn(1.5 * mm, planes);
    const double removed = turn.run.removed();
    EXPECT_GT(removed, pi * Rb * Rb * example_advance);
    EXPECT_LT(removed, pi * Rh * Rh * example_advance);
    EXPECT_GT(removed, 0.99 * 1.107e-4) << planes;
    EXPECT_LT(removed, 1.01 * 1.116e-4) << planes;
    EXPECT_NEAR(turn.run.backward_share(), 0.236, 0.005) << planes;
  }
}

void record_ratio(const std::string& claim, const std::string& what, double measured,
                  double expected, double room) {
  EXPECT_NEAR(measured, expected, room) << what;
  battery::record({claim, what, measured, "1", fmt::format("{:g} +- {:g}", expected, room),
                   std::abs(measured - expected) <= room ? battery::Verdict::holds
                                                         : battery::Verdict::refuted});
}

/// Each crossing counted for its own time, the mean loads are the same on any number of planes.
TEST(WhirlLoad, does_not_depend_on_the_number_of_planes) {
  const double weight = mean(whirl_turn(1.5 * mm, 720).run.weight),
               torque = mean(whirl_turn(1.5 * mm, 720).run.torque);
  for (const int planes : {72, 120})
    for (const ForceTime time : {ForceTime::spread, ForceTime::crossing}) {
      const BehrRun run = whirl_turn(1.5 * mm, planes, time).run;
      EXPECT_NEAR(mean(run.weight), weight, 0.004 * weight) << planes;
      EXPECT_NEAR(mean(run.torque), torque, 0.004 * torque) << planes;
    }
}

/// A cutter that turns round near the wall crosses no plane for long, and is felt all that time if
/// its force is held.
TEST(WhirlLoad, is_far_too_large_if_forces_are_held_from_plane_to_plane) {
  struct Row {
    int planes;
    double ratio, room;
  };
  for (const Row& row : {Row{72, 1.83, 0.014}, {120, 1.73, 0.0052}, {720, 1.26, 0.01}}) {
    const double held = mean(whirl_turn(1.5 * mm, row.planes, ForceTime::held).run.weight),
                 spread = mean(whirl_turn(1.5 * mm, row.planes).run.weight);
    record_ratio("chapter2/held-forces",
                 "mean weight with forces held to the next crossing over that with each counted "
                 "for its own time, bit B rolling backwards at 3 mm a revolution in a hole larger "
                 "by 1.5 mm all round, " +
                     std::to_string(row.planes) + " planes",
                 held / spread, row.ratio, row.room);
  }
}

/// A step in which a cutter crosses no plane has none of its force. Perfect geometry, bit A.
TEST(SpokeNoise, is_a_quarter_of_the_torque_in_steps_of_a_millisecond) {
  struct Row {
    int planes;
    double step, step_room, five, five_room;
  };
  for (const Row& row : {Row{72, 0.26, 0.005, 0.064, 0.0009},
                         {120, 0.23, 0.0013, 0.049, 0.0003},
                         {360, 0.067, 0.0011, 0.011, 0.001}}) {
    const std::vector<double> torque = steady_torque(row.planes, ForceTime::crossing);
    const std::string at =
        "root mean square of the torque over its mean, steady drilling, bit A, "
        "120 rpm, 3 mm a revolution, " +
        std::to_string(row.planes) + " spokes: ";
    record_ratio("chapter2/spoke-noise", at + "steps of 1 ms", relative_noise(torque, 1), row.step,
                 row.step_room);
    record_ratio("chapter2/spoke-noise", at + "averaged over 5 ms", relative_noise(torque, 5),
                 row.five, row.five_room);
  }
}

/// To hold the last crossing's force removes the noise, and delays: a change is felt only when the
/// cutter reaches its next plane, up to 4.2 ms later on 120 spokes.
TEST(SpokeNoise, is_none_if_forces_are_held_which_delays_them) {
  constexpr double chord = 1e-6;  // when a tip crosses: on the chord of its way, not its arc
  for (const ForceTime time : {ForceTime::held, ForceTime::spread})
    EXPECT_LT(relative_noise(steady_torque(120, time), 1), chord);
  BehrOptions options;
  options.planes = 120;
  options.radius = example_gage;
  const BitPath path = steady_path(example_speed, example_advance);
  BehrState state = behr_start(example_cutters('a'), path(0.0), options);
  const auto silent_after = [&](double from, double dt, int steps) {
    const BehrRun run = behr_run(state, path, from, dt, steps, rock_k(), options);
    int silent = 0;
    for (const BehrCutter& c : run.cutters) silent += c.crossings == 0;
    return silent;
  };
  EXPECT_GT(silent_after(0.0, 1e-4, 38), 0);
  EXPECT_EQ(silent_after(38e-4, 1e-4, 42), 0);
  EXPECT_NEAR(2 * pi / 120 / example_speed, 4.2e-3, 0.05e-3);
}

}  // namespace
}  // namespace tdbd::reference::behr_whirl_test

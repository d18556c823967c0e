#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/evidence.hpp"
#include "battery/generators.hpp"
#include "literature/drag/planes/behr_runs.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"

/// What planes do not see: the pattern of a whirling bit, and the way from one plane to the next.
namespace tdbd::reference::behr_whirl_test {

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
TEST(WhirlLoad, is_far_too_large_if_forces_are_constant_between_planes) {
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
TEST(SpokeNoise, vanishes_if_forces_are_constant_which_delays_them) {
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

}  // namespace tdbd::reference::behr_whirl_test

namespace tdbd::reference::bit_path_test {

constexpr double pi = std::numbers::pi, mm = 1e-3;

RollingWhirl whirl_of_120_rpm() { return {107.95 * mm, 1.5 * mm, 4 * pi}; }

TEST(RollingWhirl, turns_the_centre_72_times_as_fast_as_the_bit) {
  const RollingWhirl w = whirl_of_120_rpm();
  EXPECT_NEAR(w.whirl_speed() / w.rotary_speed, -71.967, 5e-4);
  EXPECT_NEAR(-w.whirl_speed() / (2 * pi), 143.93, 5e-3);  // Hz
  EXPECT_NEAR(w.lobes(), 72.97, 5e-3);
  const double diameter = 2 * w.bit_radius * (1 - w.rotary_speed / w.whirl_speed());
  EXPECT_NEAR(diameter, 218.900 * mm, 1e-12);
  EXPECT_NEAR(2 * w.hole_radius(), diameter, 1e-15);
}

TEST(RollingWhirl, moves_cutters_backwards_for_a_share_of_time) {
  const RollingWhirl w = whirl_of_120_rpm();
  struct Row {
    double place, share, speed;
  };
  for (const Row& row : {Row{0.25, 0.4196, 1.0157},
                         {0.5, 0.3333, 1.0635},
                         {0.75, 0.2301, 1.1465},
                         {0.99, 0.0451, 1.2670}}) {
    const double r = row.place * w.bit_radius;
    EXPECT_NEAR(backward_share(w, r), row.share, 5e-5);
    EXPECT_NEAR(mean_speed(w, r) / (w.rotary_speed * w.bit_radius), row.speed, 5e-5);
  }
}

/// The closed forms are those of the path: for any point of the bit at any time, by differences.
RC_GTEST_PROP(RollingWhirl, has_the_speeds_of_its_path, ()) {
  const RollingWhirl w{*battery::number(20.0, 200.0) * mm, *battery::number(0.5, 20.0) * mm,
                       *battery::number(0.1, 40.0)};
  const BitPath path = whirl_path(w, 0.0);
  const double r = *battery::number(0.0, 1.0) * w.bit_radius, phi = *battery::number(0.0, 6.3);
  const double t = *battery::number(0.0, 1.0), h = 1e-4 / std::abs(w.whirl_speed());
  const auto place = [&](double time) {
    const BitPlace p = path(time);
    return Vec3(p.p_WB + r * Vec3(std::cos(phi + p.angle), std::sin(phi + p.angle), 0.0));
  };
  const Vec3 v_W = (place(t + h) - place(t - h)) / (2 * h);
  const double at_point = phi + path(t).angle, contact = w.whirl_speed() * t;
  const Vec3 forward(-std::sin(at_point), std::cos(at_point), 0.0);
  const double scale = w.rotary_speed * w.bit_radius, differences = 1e-7 * scale;
  RC_ASSERT(std::abs(v_W.norm() - speed(w, r, contact - at_point)) < differences);
  RC_ASSERT(std::abs(v_W.dot(forward) - forward_speed(w, r, contact - at_point)) < differences);
  RC_ASSERT(speed(w, r, contact - at_point) <= w.rotary_speed * (r + w.bit_radius) * (1 + 1e-12));
}

/// The point of contact rests: there is no slip.
RC_GTEST_PROP(RollingWhirl, rolls_without_slip, ()) {
  const RollingWhirl w{*battery::number(20.0, 200.0) * mm, *battery::number(0.5, 20.0) * mm,
                       *battery::number(0.1, 40.0)};
  RC_ASSERT(speed(w, w.bit_radius, 0.0) == 0.0);
  RC_ASSERT(std::abs(w.whirl_speed() * w.radius + w.rotary_speed * w.bit_radius) <
            1e-14 * w.rotary_speed * w.bit_radius);
}

TEST(SteadyPath, sinks_by_the_advance_in_a_turn) {
  const BitPlace place = steady_path(4 * pi, 3 * mm)(1.25);
  EXPECT_DOUBLE_EQ(place.angle, 5 * pi);
  EXPECT_NEAR(place.p_WB.z(), 7.5 * mm, 1e-15);
  EXPECT_EQ(place.p_WB.head<2>().norm(), 0.0);
}

}  // namespace tdbd::reference::bit_path_test

namespace tdbd::reference::bottom_harmonics_test {

std::vector<double> wave(int samples, int lobes, double size, double phase) {
  std::vector<double> depth;
  depth.reserve(at(samples));
  for (int k = 0; k < samples; ++k)
    depth.push_back(0.3 + size * std::cos(2 * std::numbers::pi * lobes * k / samples + phase));
  return depth;
}

constexpr double rounding = 1e-12;

RC_GTEST_PROP(BottomHarmonics, of_a_wave_is_its_size_at_its_alias, ()) {
  const int samples = *battery::integer(3, 130), lobes = *battery::integer(0, 400);
  const int rest = lobes % samples, alias = std::min(rest, samples - rest);
  RC_PRE(alias != 0 && 2 * alias != samples);
  const double size = *battery::number(0.1, 5.0);
  const BottomHarmonics h =
      bottom_harmonics(wave(samples, lobes, size, *battery::number(0.0, 6.0)));
  RC_ASSERT(std::abs(h.amplitude[static_cast<std::size_t>(alias)] - size) < 400 * rounding);
  RC_ASSERT(strongest(h, 1).front() == alias);
  RC_ASSERT(std::abs(h.amplitude[0] - 0.3) < 400 * rounding);
}

TEST(BottomHarmonics, show_73_lobes_as_1_at_72_samples) {
  EXPECT_EQ(strongest(bottom_harmonics(wave(72, 73, 1.0, 0.4)), 1), std::vector{1});
  EXPECT_EQ(strongest(bottom_harmonics(wave(720, 73, 1.0, 0.4)), 1), std::vector{73});
}

TEST(BottomHarmonics, of_alternating_depths_have_no_twin) {
  const BottomHarmonics h = bottom_harmonics({1.0, -1.0, 1.0, -1.0});
  EXPECT_NEAR(h.amplitude[2], 1.0, rounding);
  EXPECT_EQ(h.peak_to_peak, 2.0);
}

TEST(BottomHarmonics, are_taken_on_a_circle_between_nodes) {
  Spokes rock = flat_spokes(10.0, 0.0, 3, 10);  // nodes at 0.5, 1.5, ...
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 10; ++j) rock.depth[at(k * 10 + j)] = k + 2.0 * rock.node_radius(j);
  EXPECT_EQ(depth_on_circle(rock, 4.25), (std::vector{8.5, 9.5, 10.5}));
  EXPECT_EQ(depth_on_circle(rock, 0.1), (std::vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(depth_on_circle(rock, 12.0), (std::vector{19.0, 20.0, 21.0}));
}

}  // namespace tdbd::reference::bottom_harmonics_test

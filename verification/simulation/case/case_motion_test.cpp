#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation::case_motion_test {

Case of(const std::string& name, std::vector<std::string> settings) {
  settings.emplace_back("rock.edge_length='5 mm'");
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

/// What is refused, in its own words; empty: nothing.
std::string refusal(const std::string& name, const std::vector<std::string>& settings) {
  try {
    of(name, settings);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_named(const std::string& found, const std::string& message) {
  EXPECT_NE(found.find(message), std::string::npos) << found;
}

TEST(ReadMotion, sets_the_numbers_of_whirl_and_tilt) {
  const Motion whirl =
      of("bit-b-steady", {"motion.kind=whirl", "motion.whirl={radius=0.001, frequency=20, ramp=3}"})
          .motion;
  EXPECT_EQ(whirl.whirl.radius, 0.001);
  EXPECT_EQ(whirl.whirl.frequency, 20.0);
  EXPECT_EQ(whirl.whirl.ramp, 3.0);
  const Tilt tilt =
      of("bit-b-steady", {"motion.tilt={angle=0.01, azimuth=0.5, frequency=7, ramp=2}"})
          .motion.tilt;
  EXPECT_EQ(tilt.angle, 0.01);
  EXPECT_EQ(tilt.azimuth, 0.5);
  EXPECT_EQ(tilt.frequency, 7.0);
  EXPECT_EQ(tilt.ramp, 2.0);
}

TEST(ReadMotion, follows_its_legs) {
  const Case c = of("bit-b-steady",
                    {"motion={kind='legs', start=[0.1, 0.2, 0.3], legs=[{duration=2, velocity=[0, "
                     "0, 0.001], rotary_speed=1}, {duration=3, velocity=[0.002, 0, 0]}]}",
                     "time={step=0.002}"});
  ASSERT_EQ(c.motion.path.size(), 1U + 2U + 1U);
  EXPECT_EQ(c.motion.path.front().p_WB, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(c.motion.path.back().time, 5.0);
  EXPECT_LT((c.motion.path.back().p_WB - Vec3(0.106, 0.2, 0.302)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(c.motion.path.back().turned, 2.0);
  EXPECT_EQ(c.time.steps, 2500) << "as long as the path";
}

/// Before a path of them is made: it would have a row for every quarter of a turn.
TEST(ReadMotion, rejects_legs_of_too_many_turns) {
  expect_named(refusal("bit-b-steady",
                       {"motion={kind='legs', legs=[{duration=1, rotary_speed=10}, {duration=1e12, "
                        "rotary_speed=10}]}",
                        "time={step=0.002, duration=0.1}"}),
               "legs[1].duration: found 1.592e+12 revolutions at the end of this leg, expected at "
               "most 250000 in all legs");
  expect_named(refusal("bit-b-steady", {"motion={kind='legs'}", "time={step=0.002, duration=0.1}"}),
               "legs: found none, expected one [[motion.legs]] or more");
}

TEST(ReadMotion, sets_the_motion_of_the_top) {
  const Motion loaded =
      of("drill-bit-b", {"motion.weight_on_bit=25000", "motion.expected_rate=0.004"}).motion;
  EXPECT_EQ(loaded.driven.top.axial, dynamics::AxialMode::load);
  EXPECT_EQ(dynamics::value_at(loaded.driven.top.load, 0.0), 25000.0);
  EXPECT_EQ(loaded.rate_of_penetration, 0.004);
  EXPECT_DOUBLE_EQ(loaded.rotary_speed, 4.0 * std::numbers::pi);
  EXPECT_EQ(loaded.driven.torque_at_start, 2600.0);
  EXPECT_DOUBLE_EQ(loaded.driven.top.following_time, 0.5);  // one turn at 120 rpm
  EXPECT_EQ(of("drill-bit-b", {"motion.rotary_speed=0"}).motion.driven.top.following_time, 0.0);
  EXPECT_EQ(of("drill-bit-b",
               {"motion.rotary_speed={times=[0, 1], values=['0 rpm', '60 rpm'], between='linear'}"})
                .motion.driven.top.following_time,
            1.0);
  EXPECT_EQ(of("drill-bit-b", {"motion.rate_memory=3"}).motion.driven.top.following_time, 3.0);
  expect_named(refusal("drill-bit-b", {"motion.rate_of_penetration=0.001"}),
               "found weight_on_bit and rate_of_penetration, expected weight_on_bit or "
               "rate_of_penetration");
}

TEST(ReadMotion, has_a_speed_for_every_cone) {
  EXPECT_EQ(of("bit-r-steady", {"motion.cone_speeds=[1.4, 1.5, 1.6]"}).motion.cones.speeds,
            (std::vector{1.4, 1.5, 1.6}));
  expect_named(refusal("bit-r-steady", {"motion.cone_speeds=[1.4, 1.5]"}),
               "motion.cone_speeds: found 2 speeds, expected one for each of the bit's 3 cones");
  const Motion rolling = of("bit-r-rolling", {"motion.rotary_speed=5"}).motion;
  EXPECT_EQ(rolling.cones.drive, ConeDrive::rolling);
  EXPECT_DOUBLE_EQ(rolling.cones.memory, 0.1 / 5.0) << "a tenth of a radian of the bit";
  expect_named(refusal("bit-b-steady", {"motion.cone_speeds=rolling"}),
               "motion.cone_speeds: found \"rolling\", expected a bit with cones");
}

TEST(ReadMotion, starts_near_its_rock) {
  EXPECT_EQ(of("bit-b-steady", {"motion.start=[1, -2, 3]"}).motion.start_W, Vec3(1.0, -2.0, 3.0));
  expect_named(refusal("bit-b-steady", {"motion.start=[0, -2e5, 0]"}),
               "motion.start: found [0, -200000, 0] m, expected a place within 1e+05 m");
}

}  // namespace tdbd::simulation::case_motion_test

#include "simulation/case/case.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "core/temporary_file.hpp"

namespace tdbd::simulation::case_test {

constexpr double pi = std::numbers::pi;

/// The least that a case has to say.
std::string least() {
  return std::string("[bit]\nfile = \"") + TDBD_SOURCE_DIR +
         "/cases/bits/bit-b.toml\"\n[rock]\nedge_length = \"2 mm\"\n[motion]\nrotary_speed = "
         "\"60 rpm\"\nrate_of_penetration = \"36 m/h\"\n[time]\nstep = \"1 ms\"\nrevolutions = 2\n";
}

Case case_with(const std::vector<std::string>& overrides) {
  return read_case(write_temporary(".toml", least()), overrides);
}

TEST(ReadCase, gives_si_and_the_defaults) {
  const Case c = case_with({});
  EXPECT_EQ(c.bit.name, "bit-b");
  EXPECT_EQ(c.rock.shape, RockShape::conforming);
  EXPECT_EQ(c.rock.edge_length, 0.002);
  EXPECT_EQ(c.rock.wall, 0.03);
  EXPECT_EQ(c.motion.kind, MotionKind::steady);
  EXPECT_NEAR(c.motion.rotary_speed, 2.0 * pi, 1e-14);
  EXPECT_NEAR(c.motion.rate_of_penetration, 0.01, 1e-17);
  EXPECT_EQ(c.time.step, 0.001);
  EXPECT_EQ(c.time.steps, 2000);
  EXPECT_EQ(c.maintenance.every, MaintenancePlan{}.every);
  EXPECT_EQ(c.output.history_every, 1);
  EXPECT_EQ(c.output.frames_every, 0);
}

TEST(ReadCase, whirl_is_backward_and_grows_over_one_turn_unless_told) {
  const Case c = case_with(
      {"motion.kind=whirl", "motion.whirl.radius=1 mm", "motion.whirl.frequency=10 rad/s"});
  EXPECT_EQ(c.motion.whirl.sense, WhirlSense::backward);
  EXPECT_NEAR(c.motion.whirl.ramp, 1.0, 1e-15);
  const Case forward =
      case_with({"motion.kind=whirl", "motion.whirl.radius=1 mm", "motion.whirl.frequency=10 rad/s",
                 "motion.whirl.sense=forward", "motion.whirl.ramp=0"});
  EXPECT_EQ(forward.motion.whirl.sense, WhirlSense::forward);
  EXPECT_EQ(forward.motion.whirl.ramp, 0.0);
}

TEST(ReadCase, the_resolved_text_is_the_same_case) {
  const Case c = case_with(
      {"motion.kind=whirl", "motion.whirl.radius=1 mm", "motion.whirl.frequency=10 rad/s"});
  const Case again = read_case(write_temporary("_resolved.toml", c.resolved), {});
  EXPECT_EQ(again.resolved, c.resolved);
  EXPECT_EQ(again.hash, c.hash);
  EXPECT_EQ(again.motion.rotary_speed, c.motion.rotary_speed);
  EXPECT_EQ(again.time.steps, c.time.steps);
}

TEST(ReadCase, the_resolved_text_writes_every_default_out) {
  const std::string text = case_with({}).resolved;
  for (const char* line :
       {"wall = 0.03  # m\n", "kind = \"steady\"\n", "edge_length = 0.002  # m\n",
        "shape = \"conforming\"\n", "history_every = 1\n", "directions = \"hybrid\"\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST(ReadCase, the_hash_follows_every_value) {
  const std::string hash = case_with({}).hash;
  EXPECT_EQ(case_with({"rock.edge_length=0.002"}).hash, hash);
  EXPECT_NE(case_with({"rock.edge_length=0.0021"}).hash, hash);
  EXPECT_NE(case_with({"output.history_every=2"}).hash, hash);
}

TEST(ReadCase, knows_all_files_that_it_read) {
  const Case c = case_with({});
  ASSERT_EQ(c.files.size(), 4u);  // the case, the bit, and the bit with its table
  EXPECT_EQ(c.files[0], c.path);
  EXPECT_NE(c.files.back().find("bit-b.csv"), std::string::npos);
}

TEST(ReadCase, revolutions_need_a_turning_bit) {
  try {
    case_with({"motion.rotary_speed=0"});
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("time.revolutions: found a motion without rotary speed"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace tdbd::simulation::case_test

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
  EXPECT_EQ(c.maintenance.every, rock::MaintenanceOptions{}.every);
  EXPECT_EQ(c.output.history_every, 1);
  EXPECT_EQ(c.output.frames_every, 0);
}

/// The hash of a case without a title does not depend on the key.
TEST(ReadCase, has_a_title_or_the_name_of_its_bit) {
  EXPECT_EQ(case_with({}).title, "bit-b");
  EXPECT_EQ(case_with({}).resolved.find("title"), std::string::npos);
  EXPECT_EQ(case_with({"title="}).title, "bit-b");
  const Case c = case_with({"title=Bit B in shale"});
  EXPECT_EQ(c.title, "Bit B in shale");
  EXPECT_EQ(read_case(write_temporary("_resolved.toml", c.resolved), {}).title, c.title);
}

TEST(ReadCase, whirl_is_backward_and_grows_over_one_turn_by_default) {
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

TEST(ReadCase, lists_all_files_that_it_read) {
  const Case c = case_with({});
  ASSERT_EQ(c.files.size(), 4u);  // the case, the bit, and the bit with its table
  EXPECT_EQ(c.files[0], c.path);
  EXPECT_NE(c.files.back().find("bit-b.csv"), std::string::npos);
}

TEST(ReadCase, stores_every_number_in_its_field) {
  const Case c = case_with(
      {"maintenance={every=2, rest=3, longest_wait=11, renumber_every=7, shortest_edge=0.3, "
       "longest_edge=1.9, worst_quality=0.11, flip_quality=0.22, smooth_quality=0.33}",
       "measure={section='ahead', section_lead=0.4, contact='on', contact_gap=0.15, "
       "section_every=5}",
       "update.most_passes=17",
       "output={history_every=3, frames_every=4, checkpoint_every=9, means_from=0.25}",
       "rock.trim=0.2", "time.first_step=100"});
  EXPECT_EQ(c.maintenance.every, 2);
  EXPECT_EQ(c.maintenance.rest, 3);
  EXPECT_EQ(c.maintenance.longest_wait, 11);
  EXPECT_EQ(c.maintenance.renumber_every, 7);
  EXPECT_EQ(c.maintenance.shortest_edge, 0.3);
  EXPECT_EQ(c.maintenance.longest_edge, 1.9);
  EXPECT_EQ(c.maintenance.worst_quality, 0.11);
  EXPECT_EQ(c.maintenance.flip_quality, 0.22);
  EXPECT_EQ(c.maintenance.smooth_quality, 0.33);
  EXPECT_EQ(c.measure.section_lead, 0.4);
  EXPECT_EQ(c.measure.contact_gap, 0.15);
  EXPECT_EQ(c.measure.section_every, 5);
  EXPECT_EQ(c.update.most_passes, 17);
  EXPECT_EQ(c.output.history_every, 3);
  EXPECT_EQ(c.output.frames_every, 4);
  EXPECT_EQ(c.output.checkpoint_every, 9);
  EXPECT_EQ(c.output.means_from, 0.25);
  EXPECT_EQ(c.rock.trim, 0.2);
  EXPECT_EQ(c.time.first, 100);
}

/// Of what is left to run: two seconds, or one and a half.
TEST(ReadCase, means_are_those_of_the_second_half_by_default) {
  EXPECT_DOUBLE_EQ(case_with({}).output.means_from, 1.0);
  EXPECT_DOUBLE_EQ(case_with({"time.first_step=500"}).output.means_from, 0.75);
}

/// What is refused, in its own words; empty: nothing.
std::string refusal(const std::vector<std::string>& overrides) {
  try {
    case_with(overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// This mistake and no other.
void expect_refused(const std::vector<std::string>& overrides, const std::string& message) {
  const std::string found = refusal(overrides);
  EXPECT_TRUE(found.ends_with(message)) << found;
  EXPECT_EQ(found.find('\n'), std::string::npos) << found;
}

TEST(ReadCase, revolutions_need_a_turning_bit) {
  expect_refused({"motion.rotary_speed=0"},
                 "time.revolutions: found a motion without rotary speed, expected time.duration "
                 "instead");
}

TEST(ReadCase, has_one_length) {
  expect_refused({"time.duration=1"},
                 "time.revolutions: found duration as well, expected one of the two");
}

/// Two seconds: no step at all, or more than any machine makes, or one that turns too far.
TEST(ReadCase, has_steps_that_fit) {
  EXPECT_EQ(refusal({"time.step=0.04"}), "");
  expect_refused({"motion.rotary_speed=0.01", "time={step=7, duration=3}"},
                 "time.step: found 7 s for a run of 3 s, expected at most the duration");
  expect_refused({"time.step=1e-10"},
                 "time.step: found 1e-10 s for a run of 2 s, which makes 2e+10 steps, expected at "
                 "most 1e+10 steps");
  expect_refused({"time.step=0.1"},
                 "time.step: found a turn of 0.628 rad in one step, expected at most 0.5 rad");
  EXPECT_EQ(refusal({"time.first_step=1999"}), "");
  expect_refused({"time.first_step=2000"},
                 "time.first_step: found 2000 of 2000 steps, expected a step before the end of the "
                 "run");
}

TEST(ReadCase, that_continues_has_no_memory_of_cones) {
  const std::string bit = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";
  const std::vector<std::string> rolling{"bit.file=" + bit, "motion.cone_speeds=rolling"};
  EXPECT_EQ(refusal(rolling), "");
  expect_refused({rolling[0], rolling[1], "time.first_step=10"},
                 "time.first_step: found 10 with rolling cones, expected 0: the earlier contacts "
                 "of cones are not in any file");
}

TEST(ReadCase, reports_the_mistakes_of_a_bit_once) {
  const std::string bit = write_temporary(".bit.toml", "name = 1\n");
  const std::string found =
      refusal({"bit.file=" + bit, "forces={law='detournay', eps=3e7, zeta=0.6}",
               "rock.material=berea-sandstone"});
  EXPECT_NE(found.find("name: found 1"), std::string::npos) << found;
  EXPECT_EQ(found.find("forces"), std::string::npos) << found;
}

}  // namespace tdbd::simulation::case_test

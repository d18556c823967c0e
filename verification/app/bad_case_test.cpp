#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app {
namespace {

TEST(bad_case, that_the_small_case_is_right) {
  const SmallCase c;
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
  EXPECT_EQ(c.run().exit_code, 0);
}

TEST(bad_case, an_unknown_unit) {
  const SmallCase c;
  c.edit("case.toml", "4 mm", "4 furlogs");
  expect_refused(c,
                 "case.toml:4: rock.edge_length: found \"4 furlogs\" (unknown unit furlogs), "
                 "expected length in m or another unit of it");
}

TEST(bad_case, a_wrong_dimension) {
  const SmallCase c;
  c.edit("case.toml", "120 rpm", "120 kg");
  expect_refused(c,
                 "case.toml:7: motion.rotary_speed: found \"120 kg\" (kg is mass), expected "
                 "angular speed in rad/s or another unit of it");
}

TEST(bad_case, a_misspelt_key) {
  const SmallCase c;
  c.edit("case.toml", "wall =", "wal =");
  expect_refused(c, "case.toml:5: rock.wal: found an unknown key, expected wall");
}

TEST(bad_case, a_missing_key) {
  const SmallCase c;
  c.edit("case.toml", "step = \"2 ms\"\n", "");
  expect_refused(c,
                 "case.toml:9: time.step: found nothing, expected time in s, > 0 (the key is "
                 "required)");
}

TEST(bad_case, a_step_that_is_negative_or_zero) {
  for (const std::string step : {"-2 ms", "0 ms"}) {
    const SmallCase c;
    c.edit("case.toml", "2 ms", step);
    expect_refused(c, "case.toml:10: time.step: found \"" + step + "\", expected time in s, > 0");
  }
}

TEST(bad_case, a_step_beyond_the_run) {
  const SmallCase c;
  c.edit("case.toml", "40 ms", "0.5 ms");
  expect_refused(
      c,
      "case.toml:10: time.step: found 0.002 s for a run of 0.0005 s, expected at most the "
      "duration");
}

TEST(bad_case, a_step_that_turns_the_bit_far) {
  const SmallCase c;
  c.edit("case.toml", "120 rpm", "1e6 rpm");
  expect_refused(c,
                 "case.toml:10: time.step: found a turn of 209 rad in one step, expected at "
                 "most 0.5 rad");
}

TEST(bad_case, revolutions_and_duration_together) {
  const SmallCase c;
  c.edit("case.toml", "duration", "revolutions = 1\nduration");
  expect_refused(c,
                 "case.toml:11: time.revolutions: found duration as well, expected one of the two");
}

TEST(bad_case, a_missing_case_file) {
  const SmallCase c;
  std::filesystem::remove(c.path("case.toml"));
  expect_refused(c, "case.toml: found no such file, expected a TOML file");
}

TEST(bad_case, a_missing_bit_file) {
  const SmallCase c;
  std::filesystem::remove(c.path("bit.toml"));
  expect_refused(c, "case.toml:2: bit.file: found \"bit.toml\" (there is no " +
                        c.path("bit.toml").string() +
                        "), expected the path of an existing file, from the case file's folder");
}

TEST(bad_case, a_wrong_override_is_named_as_such) {
  const SmallCase c;
  const auto o = c.run({"--set", "time.step=-1"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "tdbd: --set: time.step: found -1, expected time in s, > 0\n");
}

TEST(bad_case, a_rock_beyond_memory) {
  const SmallCase c;
  c.edit("case.toml", "20 mm", "1e5 km");
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("rock.edge_length: found 0.004 m, which makes "), std::string::npos)
      << o.err;
}

TEST(bad_case, a_motion_beyond_memory) {
  const SmallCase c;
  c.edit("case.toml", "30 m/h", "1e9 km/s");
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("case.toml: motion: found a way of "), std::string::npos) << o.err;
}

/// Every mistake of a case, its bit file and its tables at once, in the order of the lines.
TEST(bad_case, all_mistakes_at_once) {
  const SmallCase c;
  c.edit("case.toml", "4 mm", "4 furlogs");
  c.edit("case.toml", "wall =", "wal =");
  c.edit("case.toml", "2 ms", "-2 ms");
  c.edit("bit.toml", "24", "\"many\"");
  c.edit("bit.csv", "S,3,1", "S,2,one");
  const std::string at = c.path("").string();
  EXPECT_EQ(c.check().err,
            "tdbd: " + at +
                "case.toml:4: rock.edge_length: found \"4 furlogs\" (unknown unit "
                "furlogs), expected length in m or another unit of it\n" +
                at + "case.toml:5: rock.wal: found an unknown key, expected wall\n" + at +
                "case.toml:10: time.step: found \"-2 ms\", expected time in s, > 0\n" + at +
                "bit.toml:5: mesh.rim_segments: found \"many\", expected a whole number from "
                "8 to 4096\n" +
                at + "bit.csv:4: blade: found 'one', expected a whole number\n" + at +
                "bit.csv:4: cutter: found 2, as in line 3, expected a number of its own\n");
}

TEST(bad_case, a_wrong_command_line) {
  using Arguments = std::vector<std::string>;
  for (const Arguments& arguments :
       {Arguments{}, {"drill"}, {"run"}, {"run", "a.toml", "--colour"}}) {
    const auto o = battery::run_tdbd(arguments);
    EXPECT_EQ(o.exit_code, 2);
    EXPECT_NE(o.err, "");
  }
  const auto o = SmallCase{}.run({"--threads", "0"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("--threads"), std::string::npos) << o.err;
}

}  // namespace
}  // namespace tdbd::app

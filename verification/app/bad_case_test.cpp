#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "app/mistake.hpp"
#include "app/small_case.hpp"

namespace tdbd::app::bad_case_test {

TEST(BadCase, that_the_small_case_is_right) {
  const SmallCase c;
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
  EXPECT_EQ(c.run().exit_code, 0);
}

class BadCase : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadCase, is_rejected_with_its_place_and_reason) {
  const SmallCase c;
  c.edit("case.toml", GetParam().from, GetParam().to);
  expect_refused(c, std::string("case.toml:") + GetParam().message);
}

const Mistake mistakes[] = {
    {"an_unknown_unit", "4 mm", "4 furlogs",
     "4: rock.edge_length: found \"4 furlogs\" (unknown unit furlogs), "
     "expected length in m or in another unit"},
    {"a_wrong_dimension", "120 rpm", "120 kg",
     "7: motion.rotary_speed: found \"120 kg\" (kg is mass), expected "
     "angular speed in rad/s or in another unit"},
    {"a_misspelt_key", "wall =", "wal =", "5: rock.wal: found an unknown key, expected wall"},
    {"a_missing_key", "step = \"2 ms\"\n", "",
     "9: time.step: found nothing, expected time in s, > 0 (the key is "
     "required)"},
    {"a_step_beyond_the_run", "40 ms", "0.5 ms",
     "10: time.step: found 0.002 s for a run of 0.0005 s, expected at most the "
     "duration"},
    {"a_step_that_turns_the_bit_far", "120 rpm", "1e6 rpm",
     "10: time.step: found a turn of 209 rad in one step, expected at "
     "most 0.5 rad"},
    {"revolutions_and_duration_together", "duration", "revolutions = 1\nduration",
     "11: time.revolutions: found duration as well, expected one of the two"},
    {"a_motion_that_jumps_past_a_part", "30 m/h", "20 m/s",
     "10: time.step: found a jump of 40.2 mm of cutter-1/face in one step of "
     "0.002 s, expected at most the part's size, 22.7 mm: a shorter time.step or a "
     "slower motion"},
    {"a_first_step_beyond_the_run", "duration", "first_step = 20\nduration",
     "11: time.first_step: found 20 of 20 steps, expected a step before the "
     "end of the run"},
    {"far_too_many_steps", "2 ms", "1e-30 ms",
     "10: time.step: found 1e-33 s for a run of 0.04 s, which makes 4e+31 steps, expected at most "
     "1e+10 steps"},
    {"a_wall_longer_than_any_borehole", "20 mm", "1e30 m",
     "5: rock.wall: found \"1e30 m\", expected length in m, in [0, 100000]"},
    {"a_start_beyond_any_borehole", "rotary_speed", "start = [0, 0, 1e30]\nrotary_speed",
     "7: motion.start: found [0, 0, 1e+30] m, expected a place within 1e+05 m"},
    {"a_renumbering_every_minus_one_steps", "\"40 ms\"",
     "\"40 ms\"\n[maintenance]\nrenumber_every = -1",
     "13: maintenance.renumber_every: found -1, expected a whole number from 0 to 1000000000"},
};

INSTANTIATE_TEST_SUITE_P(One, BadCase, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

TEST(BadCase, a_step_that_is_negative_or_zero) {
  for (const std::string step : {"-2 ms", "0 ms"}) {
    const SmallCase c;
    c.edit("case.toml", "2 ms", step);
    expect_refused(c, "case.toml:10: time.step: found \"" + step + "\", expected time in s, > 0");
  }
}

TEST(BadCase, a_missing_case_file) {
  const SmallCase c;
  std::filesystem::remove(c.path("case.toml"));
  expect_refused(c, "case.toml: found no such file, expected a TOML file");
}

TEST(BadCase, a_missing_bit_file) {
  const SmallCase c;
  std::filesystem::remove(c.path("bit.toml"));
  expect_refused(c, "case.toml:2: bit.file: found \"bit.toml\" (there is no " +
                        c.path("bit.toml").string() +
                        "), expected the path of an existing file, from the case file's folder");
}

TEST(BadCase, a_wrong_override_is_named_as_such) {
  const SmallCase c;
  const auto o = c.run({"--set", "time.step=-1"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "tdbd: --set: time.step: found -1, expected time in s, > 0\n");
}

/// The message states the required memory before any is allocated, and a sufficient edge length.
TEST(BadCase, a_rock_beyond_memory) {
  const SmallCase c;
  c.edit("case.toml", "20 mm", "100 km");
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 2);
  for (const char* words : {"case.toml:4: rock.edge_length: found 0.004 m, which makes ",
                            " and needs ", " GB, expected at most ", " m is enough"})
    EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
}

TEST(BadCase, a_motion_beyond_memory) {
  const SmallCase c;
  c.edit("case.toml", "40 ms", "1e7 s");
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("cells of rock on a way of "), std::string::npos) << o.err;
}

/// Keys of [motion] in place of the small case's.
SmallCase moving(const std::string& lines) {
  SmallCase c;
  c.edit("case.toml", "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"30 m/h\"", lines);
  return c;
}

TEST(BadCase, legs) {
  expect_refused(moving("kind = \"legs\""),
                 "case.toml:6: motion.legs: found none, expected one [[motion.legs]] or more");
  expect_refused(moving("kind = \"legs\"\n[[motion.legs]]\nduration = 0"),
                 "case.toml:9: motion.legs[0].duration: found 0, expected time in s, > 0");
  const std::string fine = "kind = \"legs\"\n[[motion.legs]]\nduration = 1\n";
  expect_refused(
      moving(fine + "[[motion.legs]]\nduration = \"30 d\"\nrotary_speed = \"120 rpm\""),
      "case.toml:11: motion.legs[1].duration: found 5.184e+06 revolutions at the end of this leg, "
      "expected at most 250000 in all legs");
}

TEST(BadCase, a_tilt_beyond_half_a_radian) {
  expect_refused(moving("rotary_speed = 1\nrate_of_penetration = 0\n[motion.tilt]\nangle = 1"),
                 "case.toml:10: motion.tilt.angle: found 1, expected angle in rad, in [0, 0.5]; "
                 "without a unit it is in rad: did you mean \"1 deg\"?");
}

TEST(BadCase, a_profile_off_the_axis_or_of_one_point) {
  const std::string expected =
      ", expected two points or more, [radius, depth], the first on the axis, the others beside it";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"[[0.01, 0], [0.06, 0]]", "a first point of radius 0.01 m"},
      {"[[0, 0]]", "1 points"},
      {"[[0, 0], [0.06, 0], [0, -0.1]]", "radius 0 m of point 3"},
      {"[[0, 0], [0.06, 0], [0.06, 0]]", "point 2 twice"}};
  for (const auto& [profile, found] : wrong) {
    const SmallCase c;
    c.edit("case.toml", "wall = \"20 mm\"", "shape = \"profile\"\nprofile = " + profile);
    expect_refused(c, "case.toml:6: rock.profile: found " + found + expected);
  }
}

TEST(BadCase, a_profile_that_crosses_itself) {
  const SmallCase c;
  c.edit("case.toml", "wall = \"20 mm\"",
         "shape = \"profile\"\n"
         "profile = [[0, 0.01], [0.07, 0.01], [0.07, -0.02], [0.06, 0.03], [0.08, -0.05]]");
  const auto o = c.run();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err.rfind("tdbd: " + c.path("case.toml").string() + ":6: rock.profile: found ", 0),
            0u)
      << o.err;
}

TEST(BadCase, a_roughness_finer_than_the_mesh) {
  const SmallCase c;
  c.edit("case.toml", "wall = \"20 mm\"",
         "shape = \"rough\"\namplitude = \"1 mm\"\ncorrelation_length = \"5 mm\"");
  expect_refused(c,
                 "case.toml:7: rock.correlation_length: found 0.005 m, expected at least two "
                 "edges, 0.008 m");
}

/// Every mistake of a case, its bit file and its tables at once, in the order of the lines.
TEST(BadCase, all_mistakes_at_once) {
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
                "furlogs), expected length in m or in another unit\n" +
                at + "case.toml:5: rock.wal: found an unknown key, expected wall\n" + at +
                "case.toml:10: time.step: found \"-2 ms\", expected time in s, > 0\n" + at +
                "bit.toml:5: mesh.rim_segments: found \"many\", expected a whole number from "
                "8 to 4096\n" +
                at + "bit.csv:4: blade: found 'one', expected a whole number\n" + at +
                "bit.csv:4: cutter: found 2, as in line 3, expected a number of its own\n");
}

TEST(BadCase, a_wrong_command_line) {
  using Arguments = std::vector<std::string>;
  for (const Arguments& arguments : {Arguments{"drill"}, {"run"}, {"run", "a.toml", "--colour"}}) {
    const auto o = battery::run_tdbd(arguments);
    EXPECT_EQ(o.exit_code, 2);
    EXPECT_NE(o.err, "");
  }
  const auto o = SmallCase{}.run({"--threads", "0"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("--threads"), std::string::npos) << o.err;
}

/// Another database of units would change results without a word.
TEST(BadCase, surroundings_do_not_change_units) {
  const SmallCase c;
  setenv("UDUNITS2_XML_PATH", "/no/units.xml", 1);
  const auto o = c.check();
  unsetenv("UDUNITS2_XML_PATH");
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST(BadCase, a_pipe_as_a_table_and_a_loop_of_links_as_a_mesh) {
  const SmallCase c;
  std::filesystem::remove(c.path("bit.csv"));
  ASSERT_EQ(mkfifo(c.path("bit.csv").c_str(), 0600), 0);
  const auto o = c.check();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("bit.csv: found no regular file, expected a CSV table"), std::string::npos)
      << o.err;
  std::filesystem::create_symlink(c.path("loop.stl"), c.path("loop.stl"));
  const auto mesh = battery::run_tdbd({"mesh", c.path("loop.stl")});
  expect_refusal(mesh, c.path("loop.stl").string() +
                           ": found Too many levels of symbolic links, expected a mesh file");
  const auto over = battery::run_tdbd(
      {"mesh", c.path("bit.csv"), "--repair", "-o", c.path("loop.stl") / "below.stl"});
  EXPECT_EQ(over.exit_code, 2) << over.err;
}

}  // namespace tdbd::app::bad_case_test

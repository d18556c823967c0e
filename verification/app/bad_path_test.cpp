#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app::bad_path_test {

constexpr const char* head = "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n";

SmallCase case_along(const std::string& rows) {
  SmallCase c;
  c.write("path.csv", head + rows);
  c.edit("case.toml", "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"30 m/h\"",
         "kind = \"table\"\nfile = \"path.csv\"");
  return c;
}

TEST(BadPath, that_a_path_is_right) {
  const auto o = case_along("0,0,0,0,0,0,0\n0.04,0,0,0.0003,0,0,0.5\n").run();
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST(BadPath, nan) {
  expect_refused(case_along("0,0,0,0,0,0,0\n0.04,0,nan,0,0,0,0.5\n"),
                 "path.csv:3: y_m: found \"nan\", expected a finite number");
}

TEST(BadPath, decreasing_times) {
  expect_refused(case_along("0,0,0,0,0,0,0\n0.04,0,0,0,0,0,0.5\n0.03,0,0,0,0,0,0.6\n"),
                 "path.csv:4: time_s: found 0.03 after 0.04, expected rising times");
}

TEST(BadPath, one_row) {
  expect_refused(case_along("0,0,0,0,0,0,0\n"), "path.csv: found 1 rows, expected at least two");
}

TEST(BadPath, a_missing_column) {
  const SmallCase c = case_along("0,0,0,0,0,0,0\n");
  c.edit("path.csv", "time_s", "tme_s");
  expect_refused(c, "path.csv: time_s: found the column tme_s, expected a column of this name");
}

TEST(BadPath, does_not_hide_the_mistakes_of_the_case) {
  const SmallCase c = case_along("0,0,0,0,0,0,0\n0.04,0,nan,0,0,0,0.5\n");
  c.edit("case.toml", "2 ms", "-2 ms");
  c.edit("case.toml", "duration = \"40 ms\"", "");
  expect_refused(c, "case.toml:10: time.step: found \"-2 ms\", expected time in s, > 0\n" +
                        c.path("path.csv").string() +
                        ":3: y_m: found \"nan\", expected a finite number");
}

/// 36 mm in a step of 2 ms, past cutters of 16 mm.
TEST(BadPath, a_jump_past_a_part) {
  expect_refused(case_along("0,0,0,0,0,0,0\n0.02,0,0,0.0003,0,0,0.25\n0.04,0.36,0,0,0,0,0.25\n"),
                 "path.csv:4: time_s: found a jump of 36 mm of cutter-1/face in one step of 0.002 "
                 "s, expected at most the part's size, 22.7 mm: a shorter time.step or a slower "
                 "motion");
}

TEST(BadPath, a_turn_too_far_for_a_step) {
  expect_refused(case_along("0,0,0,0,0,0,0\n0.01,0,0,0,0,0,3\n0.04,0,0,0,0,0,3.1\n"),
                 "path.csv:3: time_s: found a turn of 0.6 rad in one step, expected at most 0.5 "
                 "rad");
}

}  // namespace tdbd::app::bad_path_test

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/small_case.hpp"

namespace tdbd::app::same_bytes_test {

/// Runs the case, the case again, the resolved case from its new place, and with more threads.
void expect_same_bytes(const SmallCase& c) {
  const std::vector<std::string> frames{"--quiet", "--set", "output.frames_every=7"};
  const auto first = c.run(frames, "first");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(c.run(frames, "second").exit_code, 0);
  expect_same_results(c.path("first"), c.path("second"), 10);
  const auto resolved =
      battery::run_tdbd({"run", c.path("first/case.toml"), "-o", c.path("resolved"), "--quiet"});
  ASSERT_EQ(resolved.exit_code, 0) << resolved.err;
  expect_same_results(c.path("first"), c.path("resolved"), 10);
  ASSERT_EQ(
      c.run({"--quiet", "--set", "output.frames_every=7", "--threads", "3"}, "threads").exit_code,
      0);
  expect_same_results(c.path("first"), c.path("threads"), 10);
  const auto summary = nlohmann::json::parse(read(c.path("first/summary.json")));
  EXPECT_GT(summary["removed_volume_m3"].get<double>(), 0.0);
}

void move_along(const SmallCase& c, const std::string& motion) {
  c.edit("case.toml", "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"30 m/h\"\n", motion);
}

TEST(BitwiseIdentical, steady_from_a_conforming_start) { expect_same_bytes(SmallCase{}); }

TEST(BitwiseIdentical, with_renumberings_on_the_way) {
  const SmallCase c;
  c.edit("case.toml", "\"40 ms\"", "\"40 ms\"\n[maintenance]\nrenumber_every = 6");
  expect_same_bytes(c);
}

TEST(BitwiseIdentical, until_the_first_renumbering) {
  const SmallCase c;
  for (const std::string every : {"20", "0"})
    ASSERT_EQ(c.run({"--set", "maintenance.renumber_every=" + every}, "every" + every).exit_code,
              0);
  for (const char* file : {"history.csv", "history.nc"})
    EXPECT_TRUE(read(c.path("every20") / file) == read(c.path("every0") / file)) << file;
}

TEST(BitwiseIdentical, whirl_from_a_flat_start) {
  const SmallCase c;
  c.edit("case.toml", "wall = \"20 mm\"", "shape = \"flat\"\nradius = \"60 mm\"");
  move_along(c, R"(kind = "whirl"
rotary_speed = "120 rpm"
rate_of_penetration = "300 m/h"
whirl = {radius = "1 mm", frequency = "90 rad/s", sense = "backward"}
)");
  expect_same_bytes(c);
}

TEST(BitwiseIdentical, a_path_from_the_end_of_another_run) {
  const SmallCase c;
  ASSERT_EQ(c.run({}, "before").exit_code, 0);
  c.edit("case.toml", "wall = \"20 mm\"",
         "shape = \"file\"\nfile = \"before/rock_final.ply\"\nunit = 1");
  c.write("path.csv",
          "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n"
          "0,0,0,0.00033,0,0,0.5\n0.02,0.0002,0,0.0005,0.01,0,0.75\n0.04,0,0.0002,0.0007,0,0,1\n");
  move_along(c, "kind = \"table\"\nfile = \"path.csv\"\n");
  c.edit("case.toml", "duration = \"40 ms\"\n", "");
  expect_same_bytes(c);
  const auto summary = nlohmann::json::parse(read(c.path("first/summary.json")));
  EXPECT_EQ(summary["steps"], 20);
}

/// The rock at the end of a run is bitwise identical to that at the start of the next.
TEST(BitwiseIdentical, a_rock_read_back_is_the_rock_written) {
  const SmallCase c;
  ASSERT_EQ(c.run({}, "before").exit_code, 0);
  c.edit("case.toml", "wall = \"20 mm\"",
         "shape = \"file\"\nfile = \"before/rock_final.ply\"\nunit = \"1 m\"");
  const std::string still = R"(kind = "steady"
rotary_speed = 0
rate_of_penetration = "-1 m/h"
)";
  move_along(c, still);
  ASSERT_EQ(c.run({"--set", "time.duration=0.002", "--set", "maintenance.every=0"}).exit_code, 0);
  EXPECT_TRUE(read_unstamped(c.path("out/rock_final.ply")) ==
              read_unstamped(c.path("before/rock_final.ply")));
}

/// The hash names what is read, not where it lies.
TEST(BitwiseIdentical, the_hash_of_a_case_is_that_of_its_content) {
  const SmallCase c;
  ASSERT_EQ(c.run().exit_code, 0);
  const auto hash = [&](const std::string& folder) {
    return nlohmann::json::parse(read(c.path(folder) / "summary.json"))["case_hash"];
  };
  std::filesystem::create_directory(c.path("moved"));
  for (const char* file : {"case.toml", "bit.toml", "bit.csv"})
    std::filesystem::copy(c.path(file), c.path("moved"));
  const auto run_moved = [&] {
    return battery::run_tdbd(
        {"run", c.path("moved/case.toml"), "-o", c.path("moved/out"), "--force", "--quiet"});
  };
  ASSERT_EQ(run_moved().exit_code, 0);
  EXPECT_EQ(hash("moved/out"), hash("out"));
  c.edit("moved/bit.csv", "16,34,190", "16,34,191");
  ASSERT_EQ(run_moved().exit_code, 0);
  EXPECT_NE(hash("moved/out"), hash("out"));
}

}  // namespace tdbd::app::same_bytes_test

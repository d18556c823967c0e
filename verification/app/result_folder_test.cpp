#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/small_case.hpp"

namespace tdbd::app::result_folder_test {

using Json = nlohmann::json;

TEST(ResultFolder, contains_every_file_of_the_design) {
  const SmallCase c;
  ASSERT_EQ(c.run({"--set", "output.frames_every=10"}).exit_code, 0);
  EXPECT_EQ(files_below(c.path("out")),
            (std::vector<std::string>{
                "bit.glb", "bit.json", "bit.pvd", "bit_poses.csv", "case.toml", "checkpoint.bin",
                "frames/bit_final.vtp", "frames/rock-000010.vtp", "frames/rock-000020.vtp",
                "frames/rock_final.vtp", "history.csv", "history.nc", "history.rows", "rock.pvd",
                "rock_final.ply", "summary.json", "timing.json"}));
}

TEST(ResultFolder, a_collection_has_one_frame_for_one_time) {
  const SmallCase c;
  ASSERT_EQ(c.run({"--set", "output.frames_every=10"}).exit_code, 0);
  const std::string rock = read(c.path("out/rock.pvd"));
  EXPECT_NE(rock.find("timestep=\"0.02\" file=\"frames/rock-000010.vtp\""), std::string::npos);
  EXPECT_NE(rock.find("timestep=\"0.04\" file=\"frames/rock_final.vtp\""), std::string::npos);
  EXPECT_EQ(rock.find("rock-000020.vtp"), std::string::npos);
}

TEST(ResultFolder, with_frames_the_last_line_names_a_viewer) {
  const SmallCase c;
  const std::string line = "to view it: tdbd page " + c.path("out").string() + "\n";
  const std::string with = c.run({"--set", "output.frames_every=10"}).out;
  ASSERT_GE(with.size(), line.size());
  EXPECT_EQ(with.substr(with.size() - line.size()), line);
  EXPECT_EQ(c.run({}, "other").out.find("to view it"), std::string::npos);
}

TEST(ResultFolder, the_summary_contains_the_names_that_scripts_use) {
  const SmallCase c;
  ASSERT_EQ(c.run({"--threads", "2"}).exit_code, 0);
  const Json s = Json::parse(read(c.path("out/summary.json")));
  for (const char* key :
       {"schema", "version", "commit", "compiler", "flags", "case_hash", "seed", "steps",
        "revolutions", "removed_volume_m3", "removed_volume_by_part_m3",
        "removed_volume_by_revolution_m3", "volume_ledger_defect", "rock_triangles_start",
        "rock_triangles_end", "rock_quality_min", "rock_quality_1_percent"})
    EXPECT_TRUE(s.contains(key)) << key;
  EXPECT_EQ(s["status"], "completed");
  EXPECT_EQ(s["seed"], 0);
  EXPECT_EQ(s["steps"], 20);
  EXPECT_NEAR(s["revolutions"].get<double>(), 0.08, 1e-12);
  EXPECT_LE(s["volume_ledger_defect"].get<double>(), 1e-12);
  EXPECT_TRUE(s["removed_volume_by_part_m3"].contains("cutter-3/face"));
  EXPECT_FALSE(s.contains("threads"));
  EXPECT_FALSE(s.contains("wall_seconds"));
}

TEST(ResultFolder, timing_contains_what_depends_on_the_machine) {
  const SmallCase c;
  ASSERT_EQ(c.run({"--threads", "2"}).exit_code, 0);
  const Json t = Json::parse(read(c.path("out/timing.json")));
  EXPECT_EQ(t["threads"], 2);
  for (const char* key : {"seconds_per_step_median", "wall_seconds", "peak_memory_bytes"})
    EXPECT_GT(t[key].get<double>(), 0.0) << key;
}

/// The mean weight of the summary in pounds, on the first of six lines.
TEST(Answer, is_printed_in_metric_or_field_units) {
  const SmallCaseWithForces c("");
  const auto o = c.run({"--set", "output.means_from=0"});
  const double weight = Json::parse(read(c.path("out/summary.json")))["wob_mean_n"];
  for (const char* start : {"\nweight on bit    ", "\ntorque on bit    ", "\nrate             ",
                            "\nspecific energy  ", "\nimbalance        ", "\ndiagnosis        "})
    EXPECT_NE(o.out.find(start), std::string::npos) << start << o.out;
  const auto field = c.run({"--set", "output.means_from=0", "--field-units"}, "field");
  const std::string first = "\nweight on bit    ";
  const auto at = field.out.find(first);
  ASSERT_NE(at, std::string::npos) << field.out;
  EXPECT_NEAR(std::stod(field.out.substr(at + first.size())), weight / 4.4482216, 1e-3 * weight);
  EXPECT_NE(field.out.find(" lbf\n"), std::string::npos) << field.out;
}

TEST(Progress, is_a_line_where_there_is_no_terminal) {
  const SmallCase c;
  const auto o = c.run();
  EXPECT_EQ(o.err.rfind("100 %  step 20 of 20  0.0 s left  ", 0), 0u) << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  EXPECT_EQ(o.err.find('\r'), std::string::npos);
  EXPECT_EQ(o.out.rfind("done: 20 steps, 0.080 revolutions, ", 0), 0u) << o.out;
}

TEST(Progress, comes_every_few_seconds) {
  const SmallCase c;
  const auto o = c.run({"--set", "time.duration=1e5", "--set", "motion.rate_of_penetration=1e-9"},
                       "out", {.signal_after_seconds = 5.0});
  EXPECT_EQ(o.exit_code, 130);
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 2) << o.err;
  EXPECT_NE(o.err.find(" of 50000000  "), std::string::npos) << o.err;
}

TEST(Progress, quiet_prints_nothing) {
  const SmallCase c;
  const auto o = c.run({"--quiet"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out + o.err, "");
}

TEST(Help, every_command_has_one_with_an_example) {
  for (const std::string command : {"run", "rotate", "converge", "check", "keys", "mesh", "bit"}) {
    const auto o = battery::run_tdbd({command, "--help"});
    EXPECT_EQ(o.exit_code, 0);
    EXPECT_NE(o.out.find("Example: tdbd " + command + " "), std::string::npos) << o.out;
  }
}

}  // namespace tdbd::app::result_folder_test

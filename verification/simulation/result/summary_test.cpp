#include "simulation/result/summary.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/whole_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::summary_test {

using Json = nlohmann::ordered_json;

RunSummary third() {
  RunSummary s;
  s.command = "run";
  s.title = "a \"quoted\" case";
  s.status = RunStatus::interrupted;
  s.case_hash = "abc";
  s.seed = 18446744073709551615u;
  s.steps = 12;
  s.revolutions = 1.0 / 3.0;
  s.removed_volume = 0.1 + 0.2;
  s.removed_volume_by_revolution = {0.1, 0.2};
  s.parts = {{"cutter-2/face", 0.1, {0.1, 0.0}}, {"cutter-1/face", 0.2, {0.0, 0.2}}};
  s.maintenance = {{"flips", 7}, {"splits", 3}};
  return s;
}

TEST(Summary, every_number_is_read_back_bitwise) {
  const Json json = Json::parse(to_json(third()));
  EXPECT_EQ(json["revolutions"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["removed_volume_m3"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["seed"].get<std::uint64_t>(), 18446744073709551615u);
  EXPECT_EQ(json["removed_volume_by_part_by_revolution_m3"]["cutter-1/face"][1], 0.2);
}

TEST(Summary, contains_the_names_that_scripts_use) {
  const Json json = Json::parse(to_json(third()));
  for (const char* key : {"schema",
                          "status",
                          "version",
                          "commit",
                          "compiler",
                          "flags",
                          "case_hash",
                          "seed",
                          "steps",
                          "revolutions",
                          "removed_volume_m3",
                          "removed_volume_by_part_m3",
                          "removed_volume_by_revolution_m3",
                          "removed_volume_by_part_by_revolution_m3",
                          "volume_ledger_defect",
                          "maintenance_volume_m3",
                          "rock_triangles_start",
                          "rock_triangles_end",
                          "rock_quality_min",
                          "rock_quality_1_percent",
                          "gage_radius_m",
                          "counters"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["command"], "run");
  EXPECT_EQ(json["title"], "a \"quoted\" case");
  EXPECT_EQ(json["case_hash"], "abc");
  EXPECT_EQ(json["status"], "interrupted");
  EXPECT_EQ(json["version"], provenance().version);
  EXPECT_EQ(json["counters"]["maintenance"]["flips"], 7);
  EXPECT_FALSE(json.contains("maintenance")) << "counters have an object of their own";
}

TEST(Summary, parts_stay_in_the_order_of_the_bit) {
  const Json json = Json::parse(to_json(third()));
  EXPECT_EQ(json["removed_volume_by_part_m3"].begin().key(), "cutter-2/face");
}

TEST(Summary, without_parts_the_volumes_are_an_empty_object) {
  const Json json = Json::parse(to_json(RunSummary{}));
  EXPECT_TRUE(json["removed_volume_by_part_m3"].is_object());
  EXPECT_TRUE(json["removed_volume_by_revolution_m3"].is_array());
  EXPECT_TRUE(json["counters"]["maintenance"].is_object());
}

TEST(Summary, timing_contains_what_depends_on_the_machine) {
  const Json json = Json::parse(to_json(Timing{0.25, 10.0, peak_memory_bytes(), 2}));
  EXPECT_EQ(json["seconds_per_step_median"], 0.25);
  EXPECT_EQ(json["wall_seconds"], 10.0);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_GT(json["peak_memory_bytes"].get<long>(), 1000000);
}

/// The median of an even number of steps is the longer of the two in the middle.
TEST(Summary, timing_of_steps_is_their_mean_and_their_median) {
  const Timing t = timing_of({5.0, 1.0, 9.0, 3.0, 2.0}, 21.5, 4);
  EXPECT_EQ(t.seconds_per_step_mean, 4.0);
  EXPECT_EQ(t.seconds_per_step_median, 3.0);
  EXPECT_EQ(t.wall_seconds, 21.5);
  EXPECT_EQ(t.threads, 4);
  EXPECT_GT(t.peak_memory_bytes, 1000000);
  EXPECT_LT(t.peak_memory_bytes, 1L << 40);
  EXPECT_EQ(timing_of({4.0, 1.0, 3.0, 2.0}, 10.0, 1).seconds_per_step_median, 3.0);
  const Timing none = timing_of({}, 1.0, 1);
  EXPECT_EQ(none.seconds_per_step_mean, 0.0);
  EXPECT_EQ(none.seconds_per_step_median, 0.0);
  EXPECT_GT(none.peak_memory_bytes, 1000000);
}

TEST(Summary, a_mean_over_no_step_is_null) {
  RunSummary s = third();
  s.loads = LoadStatisticsSummary{};
  s.cones = {{.name = "cone-1", .rolling_ratio_gage_row = 1.4}};
  s.faces = {{.name = "cutter-1"}};
  const Json without = Json::parse(to_json(s));
  for (const char* key : {"wob_mean_n", "tob_std_n_m", "imbalance", "means_from_s"})
    EXPECT_TRUE(without[key].is_null()) << key;
  EXPECT_TRUE(without["cones"][0]["mean_speed_ratio"].is_null());
  EXPECT_EQ(without["cones"][0]["rolling_ratio_gage_row"], 1.4);
  EXPECT_TRUE(without["sections"][0]["mean_area_m2"].is_null());
  s.loads->steps = s.cones[0].steps = s.faces[0].steps = 1;
  const Json with = Json::parse(to_json(s));
  EXPECT_EQ(with["wob_mean_n"], 0.0);
  EXPECT_EQ(with["cones"][0]["mean_speed_ratio"], 0.0);
  EXPECT_EQ(with["sections"][0]["mean_area_m2"], 0.0);
}

TEST(Summary, is_written_whole) {
  const std::filesystem::path path = tdbd::temporary_folder() + "tdbd_summary.json";
  write_text(path, to_json(third()));
  std::ifstream in(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), to_json(third()));
  EXPECT_THROW(write_text("/proc/no/summary.json", "{}"), RunError);
}

}  // namespace tdbd::simulation::summary_test

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/rotate_folder.hpp"

namespace tdbd::app::rotate_result_test {

using Json = nlohmann::json;

Json summary_of(const RotateFolder& c, const std::vector<std::string>& more = {}) {
  const auto o = c.rotate(more);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  return Json::parse(read(c.path("out/summary.json")));
}

RotateFolder free_body() {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  return c;
}

TEST(RotateResult, contains_its_files_and_no_frames) {
  const RotateFolder c;
  summary_of(c);
  EXPECT_EQ(files_below(c.path("out")),
            (std::vector<std::string>{"case.toml", "history.csv", "history.nc", "summary.json",
                                      "timing.json"}));
  EXPECT_FALSE(std::filesystem::exists(c.path("out/frames")));
}

TEST(RotateResult, the_summary_contains_the_names_that_scripts_use) {
  const RotateFolder c;
  const Json s = summary_of(c);
  for (const char* key : {"schema",
                          "version",
                          "commit",
                          "compiler",
                          "flags",
                          "case_hash",
                          "attitude",
                          "body_momentum",
                          "space_momentum",
                          "space_momentum_start",
                          "angular_velocity",
                          "cone_angles",
                          "cone_momenta",
                          "cone_spins",
                          "energy_start",
                          "energy_end",
                          "energy_scale",
                          "torque_evaluations",
                          "steps",
                          "step_s",
                          "duration_s",
                          "twist_rad",
                          "energy_drift_max",
                          "energy_drift_end",
                          "momentum_drift_max",
                          "vertical_momentum_drift_max",
                          "cone_momentum_drift_max",
                          "unit_quaternion_defect_max"})
    EXPECT_TRUE(s.contains(key)) << key;
  EXPECT_EQ(s["command"], "rotate");
  EXPECT_EQ(s["status"], "completed");
  EXPECT_EQ(s["title"], "all keys");
  EXPECT_EQ(s["steps"], 200);
  EXPECT_EQ(s["step_s"], 0.01);
  EXPECT_EQ(s["duration_s"], 2.0);
  EXPECT_EQ(s["cone_angles"].size(), 2u);
  EXPECT_FALSE(s.contains("wall_seconds"));
  const Json t = Json::parse(read(c.path("out/timing.json")));
  for (const char* key : {"seconds_per_step_mean", "seconds_per_step_median", "wall_seconds"})
    EXPECT_GT(t[key].get<double>(), 0.0) << key;
}

TEST(RotateResult, a_free_body_conserves_its_momenta_bitwise) {
  const RotateFolder c = free_body();
  for (const char* order : {"2", "4", "6", "8"}) {
    const Json s = summary_of(c, {"--force", "--set", std::string("integrator.order=") + order,
                                  "--set", "time.duration=200"});
    EXPECT_EQ(s["momentum_drift_max"], 0.0) << order;
    EXPECT_EQ(s["cone_momentum_drift_max"], 0.0) << order;
    EXPECT_EQ(s["space_momentum"], s["space_momentum_start"]) << order;
    EXPECT_LE(s["unit_quaternion_defect_max"].get<double>(), 1e-15) << order;
    EXPECT_LT(s["energy_drift_max"].get<double>(), 3e-6) << order;
    EXPECT_GT(s["energy_drift_max"].get<double>(), 0.0) << order;
  }
}

TEST(RotateResult, drifts_are_seen_between_the_rows_of_the_history) {
  const RotateFolder c = free_body();
  c.edit("case.toml", "[time]", "[load]\ngravity_moment = 3\n[time]");
  const Json every = summary_of(c);
  const Json seldom = summary_of(c, {"--force", "--set", "output.history_every=100"});
  EXPECT_EQ(lines_of(c.path("out/history.csv")), 3);
  for (const char* key : {"energy_drift_max", "momentum_drift_max"})
    EXPECT_EQ(every[key], seldom[key]) << key;
  EXPECT_GT(every["momentum_drift_max"].get<double>(), 0.1);
  EXPECT_EQ(every["vertical_momentum_drift_max"], 0.0);
}

TEST(RotateResult, a_duration_between_steps_takes_shorter_ones) {
  const RotateFolder c = free_body();
  const Json s = summary_of(c, {"--set", "time.step=0.3"});
  EXPECT_EQ(s["steps"], 7);
  EXPECT_EQ(s["step_s"], 2.0 / 7.0);
  EXPECT_NEAR(s["duration_s"].get<double>(), 2.0, 1e-15);
  const Json whole = summary_of(c, {"--force", "--set", "time.step=0.1"});
  EXPECT_EQ(whole["steps"], 20);
  EXPECT_EQ(whole["step_s"], 0.1);
}

TEST(RotateResult, a_long_history_has_about_ten_thousand_rows) {
  const RotateFolder c = free_body();
  summary_of(c, {"--set", "time.duration=600"});
  const long rows = lines_of(c.path("out/history.csv")) - 1;
  EXPECT_EQ(rows, 1 + 30000 / 3);
  EXPECT_TRUE(history_opens(c.path("out/history.nc"), rows));
}

TEST(RotateResult, a_history_ends_with_the_end) {
  const RotateFolder c = free_body();
  summary_of(c, {"--set", "output.history_every=30"});
  const std::string csv = read(c.path("out/history.csv"));
  EXPECT_EQ(lines_of(c.path("out/history.csv")), 1 + 1 + 3 + 1);  // head, t = 0, rows, end
  EXPECT_NE(csv.find("\n1.8,"), std::string::npos);
  EXPECT_NE(csv.find("\n2,"), std::string::npos);
}

/// The case, the case again, and the resolved case from its new place.
TEST(RotateResult, the_same_case_is_bitwise_identical) {
  const RotateFolder c;
  ASSERT_EQ(c.rotate({"--quiet"}, "first").exit_code, 0);
  ASSERT_EQ(c.rotate({"--quiet"}, "second").exit_code, 0);
  expect_same_results(c.path("first"), c.path("second"), 5);
  const auto resolved =
      battery::run_tdbd({"rotate", c.path("first/case.toml"), "-o", c.path("resolved"), "--quiet"});
  ASSERT_EQ(resolved.exit_code, 0) << resolved.err;
  expect_same_results(c.path("first"), c.path("resolved"), 5);
}

TEST(RotateResult, an_attitude_matrix_is_the_rotation_vector) {
  const RotateFolder c = free_body();
  const Json a = summary_of(c, {"--set", "body.rotation_vector=[0,0,1.5707963267948966]"});
  const Json b = summary_of(c, {"--force", "--set", "body.attitude=[[0,-1,0],[1,0,0],[0,0,1]]"});
  for (int i = 0; i < 9; ++i)
    EXPECT_NEAR(a["attitude"][i / 3][i % 3].get<double>(),
                b["attitude"][i / 3][i % 3].get<double>(), 1e-14);
}

/// The box of 1 m x 2 m x 3 m: m/12 (b^2 + c^2) about its centre, wherever that lies.
TEST(RotateResult, a_mesh_gives_the_inertia_about_its_centre_of_mass) {
  const RotateFolder c;
  c.write("case.toml",
          "[body]\nmesh = \"box.off\"\nunit = \"1 m\"\ndensity = 2\n"
          "angular_velocity = [1, 1, 1]\n[time]\nstep = 0.01\nduration = 0.01\n");
  const Json s = summary_of(c);  // mass 12 kg: principal inertias 4 + 9, 1 + 9, 1 + 4
  const double expected[] = {13.0, 10.0, 5.0};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(s["space_momentum_start"][i].get<double>(), expected[i], 1e-12);
}

TEST(RotateResult, progress_and_quiet) {
  const RotateFolder c;
  const auto o = c.rotate();
  EXPECT_EQ(o.err, "100 %  step 200 of 200  0.0 s left\n");
  EXPECT_EQ(o.out.rfind("done: 200 steps to t = 2 s, 201 torque evaluations\n", 0), 0u) << o.out;
  const auto quiet = c.rotate({"--quiet", "--force"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

/// |(0.7, -0.5, 2)| = 2.1772 rad/s.
TEST(RotateResult, a_hopeless_step_is_a_warning) {
  const RotateFolder c = free_body();
  EXPECT_EQ(c.rotate({"--quiet", "--set", "time.step=0.2"}).err, "");
  const std::string text =
      "time.step: the body turns by 1.09 rad in a step of 0.5 s at the start; for meaningful "
      "results use at most 0.5 rad: 0.23 s";
  const auto o = c.rotate({"--quiet", "--force", "--set", "time.step=0.5"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err, "tdbd: warning: --set: " + text + "\n");
  EXPECT_EQ(Json::parse(read(c.path("out/summary.json")))["warnings"], Json::array({text}));
}

TEST(RotateResult, the_answer_is_that_of_the_summary) {
  const RotateFolder c = free_body();
  const auto o = c.rotate();
  const Json s = Json::parse(read(c.path("out/summary.json")));
  const auto number = [&](const std::string& label) {
    const auto at = o.out.find("\n" + label);
    return at == std::string::npos ? -1e300 : std::stod(o.out.substr(at + 1 + label.size()));
  };
  EXPECT_NEAR(number("turned           ") * 2.0 * 3.14159265, s["twist_rad"].get<double>(), 2e-3);
  EXPECT_NEAR(number("axis at the end  "),
              std::acos(s["attitude"][2][2].get<double>()) * 180.0 / 3.14159265, 0.01);
  EXPECT_NEAR(number("energy           "), s["energy_start"].get<double>(), 1e-4);
}

TEST(RotateResult, an_existing_result_is_kept_without_force) {
  const RotateFolder c;
  summary_of(c);
  expect_refusal(c.rotate(),
                 "output folder " + c.path("out").string() + ": exists; --force overwrites");
}

}  // namespace tdbd::app::rotate_result_test

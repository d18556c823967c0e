#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/rotate_folder.hpp"

namespace tdbd::app::failing_rotate_test {

namespace fs = std::filesystem;

RotateFolder fast_body(const std::string& drift) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  c.edit("case.toml", "[0.7, -0.5, 2]", "[0.7, 50, 2]");
  c.edit("case.toml", "step = 0.02", "step = 0.25");
  c.edit("case.toml", "[time]", "[integrator]\ndrift = \"" + drift + "\"\n[time]");
  return c;
}

/// The step in "a step of 0.0625 s would", so that it can be tried.
double step_that_would(const std::string& failure) {
  double step = 0.0;
  const std::size_t at = failure.rfind("a step of ");
  if (at != std::string::npos) std::sscanf(failure.c_str() + at, "a step of %lf s would", &step);
  return step;
}

TEST(FailingRotate, a_drift_that_does_not_converge_names_the_step_that_would) {
  for (const char* drift : {"lie-midpoint", "lie-mean"}) {
    const RotateFolder c = fast_body(drift);
    const auto o = c.rotate({"--quiet"});
    EXPECT_EQ(o.exit_code, 1);
    const std::string failure = read(c.path("out/failure.txt"));
    EXPECT_TRUE(o.err.starts_with("tdbd: warning: ")) << o.err;  // the step is too long
    EXPECT_EQ(o.err.substr(o.err.find('\n') + 1), "tdbd: " + failure);
    EXPECT_EQ(failure.rfind("failed after 0 of 8 steps, at t = 0 s: the ", 0), 0u) << failure;
    EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
    EXPECT_FALSE(fs::exists(c.path("out/timing.json")));
    EXPECT_EQ(lines_of(c.path("out/history.csv")), 2);
    const double step = step_that_would(failure);
    ASSERT_GT(step, 0.0) << failure;
    const auto again = c.rotate({"--quiet", "--force", "--set", "time.step=" + std::to_string(step),
                                 "--set", "time.duration=" + std::to_string(step)});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_FALSE(fs::exists(c.path("out/failure.txt")));
  }
}

/// A torque spins the body up until a step turns it too far.
TEST(FailingRotate, the_history_ends_with_the_last_good_state) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  c.edit("case.toml", "[time]",
         "[load]\nspace_torque = [0, 0, 90]\n[integrator]\n"
         "drift = \"lie-mean\"\n[output]\nhistory_every = 1000\n[time]");
  c.edit("case.toml", "duration = 2", "duration = 200");
  EXPECT_EQ(c.rotate({"--quiet"}).exit_code, 1);
  const std::string failure = read(c.path("out/failure.txt"));
  long steps = 0;
  ASSERT_EQ(std::sscanf(failure.c_str(), "failed after %ld of 10000 steps", &steps), 1) << failure;
  ASSERT_GT(steps, 0);
  ASSERT_NE(steps % 1000, 0);
  const std::string csv = read(c.path("out/history.csv"));
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  EXPECT_DOUBLE_EQ(std::stod(last), 0.02 * static_cast<double>(steps));
  EXPECT_TRUE(history_opens(c.path("out/history.nc"), lines_of(c.path("out/history.csv")) - 1));
  EXPECT_GT(step_that_would(failure), 0.0) << failure;
}

TEST(FailingRotate, a_study_names_the_level) {
  const RotateFolder c = fast_body("lie-mean");
  const auto o = c.converge({"--over", "time.step", "--levels", "4", "--quiet"});
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_EQ(o.err.rfind("tdbd: level 1, time.step = 0.25: the lie-mean drift ", 0), 0u) << o.err;
  EXPECT_EQ("tdbd: " + read(c.path("orders/failure.txt")), o.err);
  EXPECT_FALSE(fs::exists(c.path("orders/convergence.json")));
}

TEST(FailingRotate, the_explicit_drifts_take_any_step) {
  for (const char* drift : {"split", "three-axis"})
    EXPECT_EQ(fast_body(drift).rotate().exit_code, 0);
}

TEST(FailingRotate, a_full_disk_leaves_no_summary) {
  for (const long bytes : {300L, 3000L, 20000L}) {
    const RotateFolder c;
    const auto o = c.rotate({}, "out", {.largest_file = bytes});
    EXPECT_EQ(o.exit_code, 1) << bytes;
    EXPECT_NE(o.err.find("cannot write " + c.path("out").string()), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
  }
}

TEST(FailingRotate, an_interrupted_run_keeps_everything_and_reports_the_interrupt) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const RotateFolder c;
    const auto o =
        c.rotate({"--set", "time.duration=1e7", "--set", "output.checkpoint_every=5000"}, "out",
                 {.signal_after = c.path("out/checkpoint.bin"), .signal = signal});
    EXPECT_EQ(o.exit_code, 130);
    EXPECT_EQ(o.out.rfind("interrupted: ", 0), 0u) << o.out;
    EXPECT_NE(o.out.find("to resume: tdbd rotate --resume "), std::string::npos) << o.out;
    const auto summary = nlohmann::json::parse(read(c.path("out/summary.json")));
    EXPECT_EQ(summary["status"], "interrupted");
    EXPECT_LT(summary["steps"].get<long>(), 1000000000L);
    EXPECT_TRUE(fs::exists(c.path("out/timing.json")));
    EXPECT_TRUE(history_opens(c.path("out/history.nc"), lines_of(c.path("out/history.csv")) - 1));
  }
}

/// Stopping early changes nothing of what was done: the last row of the history is the state at the
/// end of a shorter run.
TEST(FailingRotate, an_interrupted_run_is_the_first_part_of_the_whole_one) {
  const RotateFolder c;
  ASSERT_EQ(
      c.rotate({"--set", "time.duration=1e7", "--quiet"}, "stopped", {.signal_after_seconds = 0.3})
          .exit_code,
      130);
  const auto stopped = nlohmann::json::parse(read(c.path("stopped/summary.json")));
  const double duration = 0.01 * stopped["steps"].get<double>();
  ASSERT_EQ(c.rotate({"--quiet", "--set", "time.duration=" + std::to_string(duration)}, "whole")
                .exit_code,
            0);
  const auto whole = nlohmann::json::parse(read(c.path("whole/summary.json")));
  for (const char* key : {"steps", "attitude", "space_momentum", "cone_angles", "energy_drift_max"})
    EXPECT_EQ(stopped[key], whole[key]) << key;
}

}  // namespace tdbd::app::failing_rotate_test

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/small_case.hpp"

namespace tdbd::app::failing_run_test {

namespace fs = std::filesystem;

/// The bit walks sideways out of its hole until it meets the rim of the rock.
SmallCase sideways() {
  SmallCase c;
  c.write("path.csv", "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n0,0,0,0,0,0,0\n1,0.1,0,0,0,0,3\n");
  c.edit("case.toml", "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"30 m/h\"",
         "kind = \"table\"\nfile = \"path.csv\"");
  c.edit("case.toml", "20 mm", "0 mm");
  c.edit("case.toml", "40 ms", "1 s");
  return c;
}

TEST(FailingRun, keeps_what_is_recorded_and_is_no_result) {
  const SmallCase c = sideways();
  const auto o = c.run({"--set", "output.frames_every=1"});
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_NE(o.err.find(" swept the rock's boundary at ("), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("tdbd: failed after "), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
  EXPECT_FALSE(fs::exists(c.path("out/timing.json")));
  const std::string failure = read(c.path("out/failure.txt"));
  EXPECT_NE(o.err.find(failure), std::string::npos) << failure;
  long steps = -1;
  ASSERT_EQ(std::sscanf(failure.c_str(), "failed after %ld of 500 steps", &steps), 1) << failure;
  ASSERT_GT(steps, 0);
  EXPECT_EQ(lines_of(c.path("out/history.csv")), 1 + steps);
  EXPECT_TRUE(history_opens(c.path("out/history.nc"), steps));
  EXPECT_EQ(lines_of(c.path("out/rock.pvd")), 5 + steps);
  EXPECT_TRUE(fs::exists(c.path("out/rock_final.ply")));
}

/// Threads may be wanted where no exception leads out: that ends with a line and exit code 1, too.
TEST(FailingRun, that_gets_no_thread_ends_with_a_line) {
  for (const char* threads : {"1", "2"}) {
    const SmallCase c;
    const auto o = c.run({"--threads", threads}, "out", {.has_threads = false});
    if (o.exit_code == 126) GTEST_SKIP() << "the system takes no rule that refuses threads";
    EXPECT_EQ(o.exit_code, 1) << threads << o.err;
    EXPECT_NE(o.err.find("Resource temporarily unavailable\n"), std::string::npos) << o.err;
  }
}

/// A bound on passes that is hit names place and parts. What is kept can be looked at and is rock
/// that another run reads.
TEST(FailingRun, at_its_limit_of_passes_reports_the_position_and_keeps_a_readable_rock) {
  const SmallCase c;
  const auto o = c.run({"--set", "update.most_passes=1"});
  EXPECT_EQ(o.exit_code, 1);
  for (const char* words : {"tdbd: failed after ",
                            "rock vertices still move after 1 passes of one "
                            "step, first vertex ",
                            " mm; the parts are: cutter-"})
    EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
  EXPECT_EQ(read(c.path("out/frames/rock_final.vtp")).rfind("<?xml", 0), 0U);
  EXPECT_NE(read(c.path("out/rock.pvd")).find("frames/rock_final.vtp"), std::string::npos);
  c.edit("case.toml", "wall = \"20 mm\"",
         "shape = \"file\"\nfile = \"out/rock_final.ply\"\nunit = \"1 m\"");
  const auto again = c.run({}, "again");
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

/// HDF5 crashed in a close that failed, and rock and failure.txt were lost.
TEST(FailingRun, whose_history_cannot_be_closed_keeps_the_rest) {
  const SmallCase c;
  setenv("LD_PRELOAD", TDBD_FAILING_CLOSE, 1);
  const auto o = c.run();
  unsetenv("LD_PRELOAD");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_NE(o.err.find("history.nc.partial: Input/output error"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find(read(c.path("out/failure.txt"))), std::string::npos) << o.err;
  EXPECT_TRUE(fs::exists(c.path("out/rock_final.ply")));
  EXPECT_FALSE(fs::exists(c.path("out/history.nc")));
  EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
}

/// A checkpoint is read before the history is written, and NetCDF begins with it: HDF5 crashed at
/// the end of a resumed run that could not write.
TEST(FailingRun, that_was_resumed_and_cannot_write_ends_with_a_line) {
  const SmallCase c;
  const auto begun = c.run({"--set", "time.duration=1000", "--set", "output.checkpoint_every=5",
                            "--set", "output.frames_every=20"},
                           "out", {.signal_after = c.path("out/frames/rock-000020.vtp")});
  ASSERT_EQ(begun.exit_code, 130) << begun.err;
  const auto half = static_cast<long>(fs::file_size(c.path("out/history.nc")) / 2);
  const auto o = battery::run_tdbd({"run", "--resume", c.path("out").string(), "--quiet"},
                                   {.largest_file = half});
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_NE(o.err.find("tdbd: "), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("cannot write"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
}

/// Nothing is known of them, and 0 is not claimed.
TEST(FinishedRun, has_no_means_over_no_step) {
  const SmallCase c;
  c.edit("case.toml", "wall = \"20 mm\"", "wall = \"20 mm\"\nmaterial = \"mancos-shale\"");
  c.edit("case.toml", "duration = \"40 ms\"",
         "duration = \"40 ms\"\n[forces]\nlaw = \"hanson-hansen\"\nA1 = 1\nA3 = 0.3");
  const auto o = c.run({"--set", "output.means_from=1"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const auto summary = nlohmann::json::parse(read(c.path("out/summary.json")));
  for (const char* key : {"wob_mean_n", "rop_mean_m_per_s", "imbalance", "means_from_s"})
    EXPECT_TRUE(summary[key].is_null()) << key;
  EXPECT_TRUE(summary["forces"].empty());
}

TEST(FailingRun, forced_again_and_well_leaves_no_trace_of_the_failure) {
  const SmallCase c = sideways();
  ASSERT_EQ(c.run().exit_code, 1);
  ASSERT_EQ(c.run({"--force", "--set", "time.duration=0.002"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(c.path("out/failure.txt")));
}

TEST(InterruptedRun, keeps_everything_and_reports_the_interrupt) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const SmallCase c;
    const auto o =
        c.run({"--set", "time.duration=1000", "--set", "output.frames_every=10", "--set",
               "output.history_every=1"},
              "out", {.signal_after = c.path("out/frames/rock-000010.vtp"), .signal = signal});
    EXPECT_EQ(o.exit_code, 130);
    EXPECT_EQ(o.out.rfind("interrupted: ", 0), 0u) << o.out;
    EXPECT_NE(o.out.find("\nsaved: the results so far, and a checkpoint; "), std::string::npos)
        << o.out;
    EXPECT_NE(o.out.find("\nto resume: tdbd run --resume " + c.path("out").string() + "\n"),
              std::string::npos)
        << o.out;
    const auto summary = nlohmann::json::parse(read(c.path("out/summary.json")));
    EXPECT_EQ(summary["status"], "interrupted");
    const long steps = summary["steps"];
    EXPECT_GE(steps, 10);
    EXPECT_LT(steps, 500000);
    EXPECT_EQ(lines_of(c.path("out/history.csv")), 1 + steps);
    EXPECT_TRUE(history_opens(c.path("out/history.nc"), steps));
    EXPECT_TRUE(fs::exists(c.path("out/frames/rock_final.vtp")));
    EXPECT_TRUE(fs::exists(c.path("out/timing.json")));
  }
}

TEST(InterruptedRun, without_a_checkpoint_is_said_to_begin_at_its_start) {
  const SmallCase c;
  const auto o = c.run({"--set", "time.duration=1000", "--set", "output.frames_every=10", "--set",
                        "output.checkpoint_every=0"},
                       "out", {.signal_after = c.path("out/frames/rock-000010.vtp")});
  EXPECT_NE(o.out.find("\nsaved: the results so far, but no checkpoint: the resumed run begins at "
                       "its start\n"),
            std::string::npos)
      << o.out;
}

TEST(InterruptedRun, twice_ends_at_once_and_is_no_result) {
  const SmallCase c;
  const auto o = c.run({"--set", "time.duration=1000", "--set", "output.frames_every=10"}, "out",
                       {.signal_after = c.path("out/frames/rock-000010.vtp"),
                        .signal = SIGINT,
                        .second_signal = SIGTERM});
  EXPECT_EQ(o.exit_code, 130);
  EXPECT_NE(o.err.find("tdbd: interrupted again: ended immediately\n"), std::string::npos) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
}

/// Its rock of 11 million triangles takes a minute or more to build, and there is nothing to save.
TEST(InterruptedRun, before_its_first_step_ends_at_once) {
  const SmallCase c;
  const auto o = c.run({"--set", "rock.edge_length='0.1 mm'"}, "out",
                       {.signal_after = c.path("out"), .signal = SIGTERM});
  EXPECT_EQ(o.exit_code, 130);
  EXPECT_EQ(o.err, "tdbd: interrupted before the first step: nothing was saved\n");
  EXPECT_EQ(files_below(c.path("out")), std::vector<std::string>{});
  EXPECT_EQ(c.run().exit_code, 0) << "an empty folder is in nobody's way";
}

/// Stopping early changes nothing of what was done.
TEST(InterruptedRun, is_the_first_part_of_the_whole_one) {
  const SmallCase c;
  ASSERT_EQ(c.run({"--set", "time.duration=1000", "--set", "output.frames_every=10", "--set",
                   "output.history_every=1", "--quiet"},
                  "stopped", {.signal_after = c.path("stopped/frames/rock-000010.vtp")})
                .exit_code,
            130);
  const auto summary = nlohmann::json::parse(read(c.path("stopped/summary.json")));
  const long steps = summary["steps"];
  ASSERT_EQ(c.run({"--set", "time.duration=" + std::to_string(0.002 * static_cast<double>(steps))},
                  "whole")
                .exit_code,
            0);
  EXPECT_EQ(read(c.path("stopped/history.csv")), read(c.path("whole/history.csv")));
  EXPECT_TRUE(read_unstamped(c.path("stopped/rock_final.ply")) ==
              read_unstamped(c.path("whole/rock_final.ply")));
}

}  // namespace tdbd::app::failing_run_test

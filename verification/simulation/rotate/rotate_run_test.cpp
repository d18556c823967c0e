#include "simulation/rotate/rotate_run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

#include "core/error.hpp"
#include "simulation/result/run.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/result_files.hpp"
#include "verification/simulation/rotated_cases.hpp"

namespace tdbd::simulation::rotate_run_test {

namespace fs = std::filesystem;

/// Stops a rotation after so many of its steps.
RotateOutcome rotate_until(long steps, const RotateCase& c, RotateOptions o, bool is_resumed) {
  std::atomic<bool> stop{steps == 0};
  o.interrupted = &stop;
  o.progress = [&](long done, long) { stop = done >= steps; };
  return is_resumed ? resume_rotate(c, o) : rotate(c, o);
}

class RotateResume : public ::testing::TestWithParam<RotatedCase> {};

/// At steps of every kind: the first, with a row and without one.
TEST_P(RotateResume, writes_the_files_of_a_run_that_was_not_stopped) {
  const RotateCase c = rotated_case(
      GetParam(), {"time.duration=4", "output.history_every=7", "output.checkpoint_every=10"});
  const fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "stopped";
  rotate(c, {.folder = whole});
  EXPECT_EQ(rotate_until(0, c, {.folder = folder}, false).status, RunStatus::interrupted);
  EXPECT_FALSE(tidy_if_finished(folder));
  const RotateCase stopped = read_stopped_rotate_case(folder);
  EXPECT_EQ(stopped.hash, c.hash);
  for (const long steps : {20L, 24L, 28L, 60L})
    EXPECT_EQ(rotate_until(steps, stopped, {.folder = folder}, true).status,
              RunStatus::interrupted);
  EXPECT_EQ(resume_rotate(stopped, {.folder = folder}).status, RunStatus::completed);
  EXPECT_TRUE(tidy_if_finished(folder));
  expect_same_result_files(whole, folder);
}

INSTANTIATE_TEST_SUITE_P(Cases, RotateResume, ::testing::ValuesIn(rotated_cases()),
                         [](const auto& instance) { return instance.param.name; });

class RotateResumeOne : public ::testing::Test {
 protected:
  RotateCase c =
      rotated_case(rotated_cases()[2], {"time.duration=4", "output.checkpoint_every=50"});
  fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "stopped";
};

TEST_F(RotateResumeOne, takes_the_older_checkpoint_where_the_newest_is_torn) {
  rotate(c, {.folder = whole});
  rotate_until(130, c, {.folder = folder}, false);
  fs::resize_file(folder / "checkpoint.nc", 100);
  std::string warning;
  resume_rotate(c, {.folder = folder, .warn = [&](const std::string& w) { warning = w; }});
  EXPECT_NE(warning.find("checkpoint-previous.nc is whole, after 100 steps"), std::string::npos)
      << warning;
  expect_same_result_files(whole, folder);
}

TEST_F(RotateResumeOne, begins_anew_where_no_checkpoint_was_written) {
  rotate(c, {.folder = whole});
  rotate_until(5, c, {.folder = folder}, false);
  fs::remove(folder / "checkpoint.nc");
  resume_rotate(c, {.folder = folder});
  expect_same_result_files(whole, folder);
}

TEST_F(RotateResumeOne, is_named_where_the_other_command_is_asked) {
  rotate_until(5, c, {.folder = folder}, false);
  try {
    read_stopped_case(folder);
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(),
              folder.string() +
                  ": found a run of tdbd rotate, expected one of tdbd run; to go on: tdbd "
                  "rotate --resume " +
                  folder.string());
  }
  std::ofstream(folder / "case.toml") << resolved_head << "\n[time]\nstep = 1\n";
  EXPECT_THROW(read_stopped_rotate_case(folder), InputError);
}

}  // namespace tdbd::simulation::rotate_run_test

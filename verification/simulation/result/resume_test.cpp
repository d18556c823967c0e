#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

#include "core/error.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/result/run.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/restarted_cases.hpp"
#include "verification/simulation/result_files.hpp"

namespace tdbd::simulation::resume_test {

namespace fs = std::filesystem;

/// Stops a run after so many of its steps.
RunSummary run_until(long steps, const Case& c, RunOptions o, bool is_resumed) {
  std::atomic<bool> stop{false};
  o.interrupted = &stop;
  o.progress = [&](const Simulation& s, long) { stop = s.state.steps_done >= steps; };
  return is_resumed ? resume_run(c, o) : run(c, o);
}

class Resume : public ::testing::TestWithParam<RestartedCase> {
 protected:
  Case short_case() const {
    return restarted_case(GetParam(), {GetParam().length, "output.frames_every=20"});
  }
};

/// On one thread, then on two.
TEST_P(Resume, writes_the_files_of_a_run_that_was_not_stopped) {
  const Case c = short_case();
  const fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "stopped";
  run(c, {.folder = whole});
  EXPECT_EQ(run_until(17, c, {.folder = folder}, false).status, RunStatus::interrupted);
  EXPECT_FALSE(tidy_if_finished(folder));
  const Case stopped = read_stopped_case(folder);
  EXPECT_EQ(stopped.hash, c.hash);
  EXPECT_EQ(run_until(40, stopped, {.folder = folder, .threads = 2}, true).status,
            RunStatus::interrupted);
  EXPECT_EQ(resume_run(stopped, {.folder = folder}).status, RunStatus::completed);
  EXPECT_TRUE(tidy_if_finished(folder));
  expect_same_result_files(whole, folder);
}

INSTANTIATE_TEST_SUITE_P(Cases, Resume, ::testing::ValuesIn(restarted_cases()),
                         [](const auto& instance) { return instance.param.name; });

class ResumeOne : public ::testing::Test {
 protected:
  Case c = restarted_case(restarted_cases().front(),
                          {"time.revolutions=0.12", "output.checkpoint_every=10"});
  fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "stopped";
  std::vector<std::string> warnings;
  RunOptions options() {
    RunOptions o{.folder = folder};
    o.warn = [&](const std::string& w) { warnings.push_back(w); };
    return o;
  }
};

/// A kill between two checkpoints, before the newest was whole.
TEST_F(ResumeOne, takes_the_older_checkpoint_where_the_newest_is_torn) {
  run(c, {.folder = whole});
  run_until(35, c, options(), false);
  fs::resize_file(folder / "checkpoint.bin", fs::file_size(folder / "checkpoint.bin") / 2);
  resume_run(c, options());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("checkpoint-previous.bin is whole, after 30 steps"), std::string::npos)
      << warnings[0];
  expect_same_result_files(whole, folder);
}

TEST_F(ResumeOne, starts_from_scratch_without_a_checkpoint) {
  run(c, {.folder = whole});
  run_until(5, c, options(), false);
  fs::remove(folder / "checkpoint.bin");
  resume_run(c, options());
  expect_same_result_files(whole, folder);
}

TEST_F(ResumeOne, rejects_checkpoints_that_are_all_torn) {
  run_until(15, c, options(), false);
  for (const char* name : {"checkpoint.bin", "checkpoint-previous.bin"})
    fs::resize_file(folder / name, 100);
  EXPECT_THROW(resume_run(c, options()), InputError);
  EXPECT_TRUE(fs::exists(folder / "summary.json")) << "nothing is lost";
}

/// A kill between the summary, which is written last, and the end. The last checkpoint stays.
TEST_F(ResumeOne, tidies_what_a_finished_run_left) {
  run(c, {.folder = whole});
  const auto files = result_files(whole);
  EXPECT_TRUE(files.contains("checkpoint.bin") && files.contains("history.rows"));
  for (const char* name : {"checkpoint-new.bin", "checkpoint-previous.bin"})
    std::ofstream(whole / name) << "left";
  EXPECT_TRUE(tidy_if_finished(whole));
  EXPECT_EQ(result_files(whole), files);
}

/// A kill while the last checkpoint was put in place: under its first name it is complete, and the older one has moved.
TEST_F(ResumeOne, puts_the_last_checkpoint_of_a_finished_run_in_place) {
  run(c, {.folder = whole});
  const auto files = result_files(whole);
  fs::rename(whole / "checkpoint.bin", whole / "checkpoint-new.bin");
  std::ofstream(whole / "checkpoint-previous.bin") << "older";
  EXPECT_TRUE(tidy_if_finished(whole));
  EXPECT_EQ(result_files(whole), files);
}

/// As on a full disk, where a root's permissions would not bind: a folder stands where the file goes.
TEST_F(ResumeOne, continues_from_the_last_complete_checkpoint) {
  run(c, {.folder = whole});
  RunOptions o = options();
  std::atomic<bool> stop{false};
  o.interrupted = &stop;
  const fs::path place = folder / "checkpoint-new.bin.partial";
  o.progress = [&](const Simulation& s, long) {
    if (s.state.steps_done == 25) fs::create_directories(place / "full");
    stop = s.state.steps_done >= 45;
  };
  EXPECT_EQ(run(c, o).status, RunStatus::interrupted);
  ASSERT_EQ(warnings.size(), 1U) << "once, though three failed";
  EXPECT_NE(warnings[0].find("checkpoint-new.bin: Is a directory; the run continues"),
            std::string::npos)
      << warnings[0];
  EXPECT_EQ(read_checkpoint(folder / "checkpoint.bin", c).state.steps_done, 20);
  fs::remove_all(place);
  resume_run(c, options());
  EXPECT_EQ(warnings.size(), 1U);
  expect_same_result_files(whole, folder);
}

/// A start takes minutes in a large rock: another run would write to the same folder meanwhile.
TEST_F(ResumeOne, locks_its_folder_before_the_start) {
  Case refused = c;
  refused.rock.edge_length = 1e-6;  // more rock than any memory holds: the start refuses it
  fs::create_directories(folder);
  const auto reason = [&] {
    try {
      run(refused, options());
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(reason().find("in use"), std::string::npos) << reason();
  const FolderLock other(folder);
  EXPECT_NE(reason().find("in use"), std::string::npos) << reason();
}

/// Until it ends again, the folder is that of no finished run. What pictures it had may be gone.
TEST_F(ResumeOne, removes_the_end_of_the_interrupted_run) {
  run_until(15, c, options(), false);
  const std::vector<fs::path> ends{folder / "summary.json", folder / "timing.json"};
  for (const fs::path& file : ends) EXPECT_TRUE(fs::exists(file));
  fs::remove_all(folder / "frames");
  RunOptions o = options();
  o.started = [&] {
    for (const fs::path& file : ends) EXPECT_FALSE(fs::exists(file)) << file;
  };
  resume_run(c, o);
  for (const fs::path& file : ends) EXPECT_TRUE(fs::exists(file));
  EXPECT_TRUE(fs::exists(folder / "frames/rock_final.vtp"));
}

TEST_F(ResumeOne, rejects_a_folder_without_a_run) {
  fs::create_directories(folder);
  EXPECT_THROW(read_stopped_case(folder), InputError);
  EXPECT_FALSE(tidy_if_finished(folder));
}

}  // namespace tdbd::simulation::resume_test

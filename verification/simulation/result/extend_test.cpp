
#include <gtest/gtest.h>

#include <atomic>

#include "core/error.hpp"
#include "io/output_folder.hpp"
#include "simulation/result/run.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/restarted_cases.hpp"
#include "verification/simulation/result_files.hpp"

namespace tdbd::simulation::extend_test {

namespace fs = std::filesystem;

/// A run of 23 rows of four steps, the last row of a part, is continued to about twice its end.
const std::vector<std::string> more{"output.history_every=4", "output.frames_every=20"};

std::string message_of(const fs::path& folder, const std::vector<std::string>& overrides) {
  try {
    extend_run(folder, overrides, {});
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

class Extended : public ::testing::TestWithParam<RestartedCase> {
 protected:
  fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "extended";
  Case first = [] {
    std::vector<std::string> settings = more;
    settings.push_back(GetParam().length);
    return restarted_case(GetParam(), settings);
  }();
  /// The resolved case alone with a later end, as a user would run it.
  void run_whole(const std::string& later) {
    run(read_case((folder / "case.toml").string(), {later}), {.folder = whole});
  }
  std::string later() const {
    return GetParam().length.starts_with("time.revolutions") ? "time.revolutions=0.41"
                                                             : "time.duration='190 ms'";
  }
};

TEST_P(Extended, complete_run_equals_an_uninterrupted_one) {
  ASSERT_EQ(run(first, {.folder = folder}).status, RunStatus::completed);
  run_whole(later());
  const Case longer = extend_run(folder, {later()}, {});
  EXPECT_FALSE(fs::exists(folder / "summary.json")) << "the folder has no finished run now";
  EXPECT_EQ(resume_run(longer, {.folder = folder}).status, RunStatus::completed);
  expect_same_result_files(whole, folder);
}

INSTANTIATE_TEST_SUITE_P(Cases, Extended, ::testing::ValuesIn(restarted_cases()),
                         [](const auto& instance) { return instance.param.name; });

class ExtendedOne : public ::testing::Test {
 protected:
  Case c = restarted_case(
      {"", "bit-b-3000psi", {}, ""},
      {"time.revolutions=0.1", "output.means_from=25 ms", "output.checkpoint_every=10"});
  fs::path whole = test_folder() / "whole", folder = whole.parent_path() / "extended";

  RunSummary run_until(long steps) {
    std::atomic<bool> stop{false};
    RunOptions o{.folder = folder};
    o.interrupted = &stop;
    o.progress = [&](const Simulation& s, long) { stop = s.state.steps_done >= steps; };
    return run(c, o);
  }
};

/// The other way to state the end replaces the one of the case.
TEST_F(ExtendedOne, interrupted_run_continues_to_a_duration) {
  EXPECT_EQ(run_until(17).status, RunStatus::interrupted);
  const Case longer = extend_run(folder, {"time.duration=0.08 s"}, {});
  EXPECT_EQ(longer.time.steps, 80);
  EXPECT_EQ(longer.output.means_from, c.output.means_from);
  const RunSummary s = resume_run(longer, {.folder = folder});
  EXPECT_EQ(s.steps, 80);
  EXPECT_EQ(extend_run(folder, {"time.duration=0.09"}, {}).time.steps, 90) << "and again";
}

TEST_F(ExtendedOne, means_can_begin_after_what_is_done) {
  run(c, {.folder = folder});
  const std::vector<std::string> set{"time.revolutions=0.2", "output.means_from=70 ms"};
  const Case alone = read_case((folder / "case.toml").string(), set);
  run(alone, {.folder = whole});
  const RunSummary s = resume_run(extend_run(folder, set, {}), {.folder = folder});
  EXPECT_EQ(s.loads->steps, 30);
  expect_same_result_files(whole, folder);
}

TEST_F(ExtendedOne, a_call_that_was_killed_is_repeated) {
  run(c, {.folder = folder});
  const std::vector<std::string> set{"time.revolutions=0.2"};
  const Case before = read_stopped_case(folder);
  fs::copy(folder / "case.toml", folder.parent_path() / "case.toml");
  extend_run(folder, set, {});
  // As if it had been killed after the checkpoint and before the case.
  fs::copy(folder.parent_path() / "case.toml", folder / "case.toml",
           fs::copy_options::overwrite_existing);
  EXPECT_EQ(resume_run(extend_run(folder, set, {}), {.folder = folder}).steps, 100);
}

TEST_F(ExtendedOne, rejects_what_would_change_the_steps_that_are_done) {
  run(c, {.folder = folder});
  const auto files = result_files(folder);
  EXPECT_EQ(message_of(folder, {"rock.edge_length=2 mm"}),
            "--set: found rock.edge_length for a run that is resumed, expected one of "
            "time.duration, time.revolutions, output.means_from; its other settings are those of " +
                (folder / "case.toml").string());
  EXPECT_EQ(message_of(folder, {"time.revolutions=0.05"}),
            "--set: found an end after 0.025 s, expected one after the 0.05 s that the run has "
            "made");
  EXPECT_EQ(message_of(folder, {"time.revolutions=0.1"}),
            "--set: found an end after 0.05 s, expected one after the 0.05 s that the run has "
            "made");
  EXPECT_EQ(message_of(folder, {"time.revolutions=1", "output.means_from=0.03"}),
            "--set: output.means_from: found 0.03 s, expected 0.025 s, from which the run has its "
            "means, or at least the 0.05 s that it has made");
  EXPECT_EQ(result_files(folder), files) << "nothing was changed";
}

TEST_F(ExtendedOne, rejects_a_complete_run_without_a_checkpoint) {
  const Case without = restarted_case({"", "bit-b-3000psi", {}, ""},
                                      {"time.revolutions=0.02", "output.checkpoint_every=0"});
  run(without, {.folder = folder});
  EXPECT_EQ(message_of(folder, {"time.revolutions=1"}),
            folder.string() +
                ": found a complete run without a checkpoint (output.checkpoint_every = 0), "
                "expected one from which to continue; run the case again with the later end");
}

}  // namespace tdbd::simulation::extend_test

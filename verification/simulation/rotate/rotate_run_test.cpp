#include "simulation/rotate/rotate_run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdio>
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
  fs::resize_file(folder / "checkpoint.bin", 100);
  std::string warning;
  resume_rotate(c, {.folder = folder, .warn = [&](const std::string& w) { warning = w; }});
  EXPECT_NE(warning.find("checkpoint-previous.bin is whole, after 100 steps"), std::string::npos)
      << warning;
  expect_same_result_files(whole, folder);
}

TEST_F(RotateResumeOne, starts_from_scratch_without_a_checkpoint) {
  rotate(c, {.folder = whole});
  rotate_until(5, c, {.folder = folder}, false);
  fs::remove(folder / "checkpoint.bin");
  resume_rotate(c, {.folder = folder});
  expect_same_result_files(whole, folder);
}

/// Until it ends again, the folder is that of no finished run.
TEST_F(RotateResumeOne, removes_the_end_of_the_interrupted_run) {
  rotate_until(5, c, {.folder = folder}, false);
  const std::vector<fs::path> ends{folder / "summary.json", folder / "timing.json"};
  for (const fs::path& file : ends) EXPECT_TRUE(fs::exists(file));
  RotateOptions o{.folder = folder};
  o.started = [&] {
    for (const fs::path& file : ends) EXPECT_FALSE(fs::exists(file)) << file;
  };
  resume_rotate(c, o);
  for (const fs::path& file : ends) EXPECT_TRUE(fs::exists(file));
}

/// Both a rotation that was stopped and one that is complete, twice as long.
TEST_F(RotateResumeOne, continues_to_a_later_end) {
  const std::vector<std::string> longer{"time.duration=8"};
  rotate(c, {.folder = whole});
  rotate(read_rotate_case((whole / "case.toml").string(), longer),
         {.folder = whole.parent_path() / "long"});
  rotate_until(130, c, {.folder = folder}, false);
  for (const fs::path& shorter : {folder, whole}) {
    const RotateCase later = extend_rotate(shorter, longer, {});
    EXPECT_FALSE(fs::exists(shorter / "summary.json"));
    EXPECT_EQ(resume_rotate(later, {.folder = shorter}).status, RunStatus::completed);
    expect_same_result_files(whole.parent_path() / "long", shorter);
  }
}

TEST_F(RotateResumeOne, rejects_another_end_and_other_settings) {
  rotate(c, {.folder = folder});
  const auto refusal = [&](const std::string& change) -> std::string {
    try {
      extend_rotate(folder, {change}, {});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refusal("time.step=0.5")
                .find("--set: found time.step for a rotation that is resumed, expected "
                      "time.duration; its other settings are those of "),
            std::string::npos);
  const std::string early = refusal("time.duration=2");
  EXPECT_NE(early.find("--set: time.duration: found 2 s, expected a whole number of steps of "),
            std::string::npos)
      << early;
  EXPECT_NE(early.find(" and an end after the 4 s that the rotation has made"), std::string::npos);
  EXPECT_NE(refusal("time.duration=4"), "");
  EXPECT_NE(refusal("time.duration=8.0001"), "");
  EXPECT_TRUE(tidy_if_finished(folder));
}

/// A row of the last good state, independent of the interval of rows in the case.
TEST(RotateFailure, keeps_the_state_before_it) {
  const fs::path folder = test_folder();
  const RotateCase c = read_rotate_case(
      write_file(folder / "case.toml",
                 "[body]\ninertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]\n"
                 "angular_velocity = [0.7, -0.5, 2]\n[[cones]]\naxis = [0.8, 0, 0.6]\n"
                 "axial_inertia = 0.1\nspin = -7\n[load]\nspace_torque = [0, 0, 90]\n"
                 "[integrator]\ndrift = \"lie-mean\"\n[output]\nhistory_every = 1000\n"
                 "[time]\nstep = 0.02\nduration = 200\n"),
      {});
  std::string failure;
  try {
    rotate(c, {.folder = folder / "out"});
  } catch (const RunError& e) {
    failure = e.what();
  }
  long steps = 0;
  ASSERT_EQ(std::sscanf(failure.c_str(), "failed after %ld of 10000 steps", &steps), 1) << failure;
  ASSERT_NE(steps % 1000, 0);
  const std::string csv = result_files(folder / "out").at("history.csv");
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  EXPECT_NEAR(std::stod(last), 0.02 * static_cast<double>(steps), 1e-12);
  EXPECT_EQ(result_files(folder / "out").at("failure.txt"), failure + "\n");
  EXPECT_FALSE(fs::exists(folder / "out/summary.json"));
}

/// Whatever of its state it is: the angle of the first cone, or a momentum of the last.
TEST(RotateFailure, is_a_state_that_is_no_number) {
  const RotateCase c = rotated_case(rotated_cases()[2]);
  const auto refused = [&](auto&& change) {
    RotateSimulation s = start(c);
    change(s.rotating.state);
    try {
      advance(c, s, 0);
    } catch (const RunError&) {
      return true;
    }
    return false;
  };
  using State = dynamics::RotationState;
  EXPECT_FALSE(refused([](State&) {}));
  for (std::size_t k = 0; k < start(c).rotating.state.cone_angles.size(); ++k) {
    EXPECT_TRUE(refused([&](State& s) { s.cone_angles[k] = NAN; })) << k;
    EXPECT_TRUE(refused([&](State& s) { s.cone_momenta[k] = INFINITY; })) << k;
  }
  EXPECT_TRUE(refused([](State& s) { s.momentum_W.y() = NAN; }));
  EXPECT_TRUE(refused([](State& s) { s.q_WB.w() = NAN; }));
}

TEST_F(RotateResumeOne, is_suggested_by_the_other_command) {
  rotate_until(5, c, {.folder = folder}, false);
  try {
    read_stopped_case(folder);
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(),
              folder.string() +
                  ": found a run of tdbd rotate, expected one of tdbd run; to resume it: tdbd "
                  "rotate --resume " +
                  folder.string());
  }
  std::ofstream(folder / "case.toml") << resolved_head << "\n[time]\nstep = 1\n";
  EXPECT_THROW(read_stopped_rotate_case(folder), InputError);
}

}  // namespace tdbd::simulation::rotate_run_test

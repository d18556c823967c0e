#include "simulation/result/recorder.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/restarted_cases.hpp"
#include "verification/simulation/same_run.hpp"

namespace tdbd::simulation::checkpoint_test {

Simulation drilled(const Case& c, int steps) {
  Simulation s = start(c);
  for (int i = 0; i < steps; ++i) step(c, s);
  return s;
}

class Checkpoints : public ::testing::TestWithParam<RestartedCase> {};

/// At steps of any kind: with and without maintenance before and after them.
TEST_P(Checkpoints, resume_bitwise_identically) {
  const Case c = restarted_case(GetParam());
  Random random{20261123};
  for (int k = 0; k < 3; ++k) {
    const int before = static_cast<int>(random.uniform(1.0, 60.0)),
              after = static_cast<int>(random.uniform(1.0, 25.0));
    Simulation whole = drilled(c, before);
    const auto file = test_folder() / "checkpoint.bin";
    write_checkpoint(file, c, whole, {});
    Checkpoint saved = read_checkpoint(file, c);
    Simulation resumed = resume(c, std::move(saved.state), std::move(saved.statistics));
    expect_same_run(whole, resumed);
    for (int i = 0; i < after; ++i) {
      step(c, whole);
      step(c, resumed);
    }
    expect_same_run(whole, resumed);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Checkpoints, ::testing::ValuesIn(restarted_cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Checkpoint, keeps_what_was_written) {
  const Case c = restarted_case(restarted_cases().front());
  const HistoryWindow window{3, {1.5, 2.5}, {0.5, 0.75}, {1.0, 1.25}, {0.75, 1.0}};
  WrittenSoFar written{7,
                       window,
                       {{0.5, "frames/rock-000500.vtp"}},
                       {{0.5, {Pose{Mat3::Identity(), {1.0, 2.0, 3.0}}}}},
                       {}};
  written.order.residual = {2.01, "", {1.0, 0.5}, {3.0, 4.0}};
  const auto file = test_folder() / "checkpoint.bin";
  write_checkpoint(file, c, start(c), written);
  const WrittenSoFar read = read_checkpoint(file, c).written;
  EXPECT_EQ(read.rows, 7);
  EXPECT_EQ(read.window.steps, window.steps);
  EXPECT_EQ(read.window.sum, window.sum);
  EXPECT_EQ(read.window.least, window.least);
  EXPECT_EQ(read.window.greatest, window.greatest);
  EXPECT_EQ(read.rock_frames, written.rock_frames);
  ASSERT_EQ(read.bit_frames.size(), 1U);
  EXPECT_EQ(read.bit_frames[0].time, 0.5);
  ASSERT_EQ(read.bit_frames[0].X_WB.size(), 1U);
  EXPECT_EQ(read.bit_frames[0].X_WB[0].p, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(read.bit_frames[0].X_WB[0].R, Mat3(Mat3::Identity()));
  EXPECT_EQ(read.order.residual.order, written.order.residual.order);
  EXPECT_EQ(read.order.residual.residuals, written.order.residual.residuals);
}

/// The message from reading with this case; empty if it was read.
std::string refusal(const std::filesystem::path& file, const Case& c) {
  try {
    read_checkpoint(file, c);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(Checkpoint, names_what_changed_in_the_case) {
  const RestartedCase steady = restarted_cases().front();
  const Case c = restarted_case(steady);
  const auto file = test_folder() / "checkpoint.bin";
  write_checkpoint(file, c, start(c), {});
  const std::string text = refusal(file, restarted_case(steady, {"time.step='0.5 ms'"}));
  EXPECT_NE(
      text.find("the case has changed since: [time] found step = 0.0005, expected step = 0.001"),
      std::string::npos)
      << text;
}

}  // namespace tdbd::simulation::checkpoint_test

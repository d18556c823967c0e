#include "simulation/result/checkpoint_keeper.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "core/read_file.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::checkpoint_keeper_test {

namespace fs = std::filesystem;

CheckpointKeeper::Write writes(const std::string& text) {
  return [=](const fs::path& file) { std::ofstream(file) << text; };
}

std::string text_of(const fs::path& file) { return read_file(file, "a file of this test"); }

TEST(CheckpointKeeper, keeps_the_last_two_and_removes_all) {
  const OutputFolder folder{test_folder()};
  CheckpointKeeper keeper(folder, 10, {});
  EXPECT_FALSE(keeper.is_due(10)) << "no rows were begun";
  keeper.keep(writes("too early"));
  EXPECT_TRUE(fs::is_empty(folder.path));
  keeper.begin_rows(2, 0);
  EXPECT_TRUE(keeper.is_due(10));
  EXPECT_TRUE(keeper.is_due(30));
  EXPECT_FALSE(keeper.is_due(15));
  keeper.append(std::vector{1.0, 2.0});
  ASSERT_NE(keeper.rows(), nullptr);
  EXPECT_EQ(keeper.rows()->rows(), 1);
  keeper.keep(writes("first"));
  EXPECT_EQ(text_of(folder.checkpoint()), "first");
  EXPECT_FALSE(fs::exists(folder.previous_checkpoint()));
  keeper.keep(writes("second"));
  EXPECT_EQ(text_of(folder.checkpoint()), "second");
  EXPECT_EQ(text_of(folder.previous_checkpoint()), "first");
  EXPECT_FALSE(fs::exists(folder.new_checkpoint()));
  keeper.remove();
  EXPECT_EQ(keeper.rows(), nullptr);
  EXPECT_TRUE(fs::is_empty(folder.path));
  EXPECT_FALSE(keeper.is_due(40));
  keeper.keep(writes("too late"));
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(CheckpointKeeper, goes_on_after_the_rows_that_it_is_told_of) {
  const OutputFolder folder{test_folder()};
  {
    CheckpointKeeper keeper(folder, 1, {});
    keeper.begin_rows(1, 0);
    for (const double x : {1.0, 2.0, 3.0}) keeper.append(std::vector{x});
    keeper.keep(writes("kept"));
  }
  CheckpointKeeper keeper(folder, 1, {});
  keeper.begin_rows(1, 2);
  EXPECT_EQ(keeper.rows()->rows(), 2);
}

TEST(CheckpointKeeper, of_a_run_without_checkpoints_keeps_none) {
  const OutputFolder folder{test_folder()};
  CheckpointKeeper keeper(folder, 0, {});
  keeper.begin_rows(1, 0);
  EXPECT_EQ(keeper.rows(), nullptr);
  EXPECT_FALSE(keeper.is_due(10));
  keeper.append(std::vector{1.0});
  keeper.keep(writes("none"));
  EXPECT_TRUE(fs::is_empty(folder.path));
}

/// What costs a hundredth of the time is soon only after ten seconds.
TEST(CheckpointKeeper, that_goes_by_the_clock_keeps_none_at_once) {
  CheckpointKeeper keeper({test_folder()}, -1, {});
  keeper.begin_rows(1, 0);
  for (const long steps : {1L, 10L, 1000L}) EXPECT_FALSE(keeper.is_due(steps));
}

/// One warning, and the checkpoint before stays.
TEST(CheckpointKeeper, warns_once_where_it_cannot_write) {
  const OutputFolder folder{test_folder()};
  std::vector<std::string> warnings;
  CheckpointKeeper keeper(folder, 1, [&](const std::string& w) { warnings.push_back(w); });
  keeper.begin_rows(1, 0);
  keeper.keep(writes("good"));
  for (int i = 0; i < 2; ++i)
    keeper.keep([](const fs::path&) { throw std::runtime_error("no room"); });
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0], "no room; the run goes on, to be resumed from its last good checkpoint");
  EXPECT_EQ(text_of(folder.checkpoint()), "good");
  EXPECT_FALSE(fs::exists(folder.previous_checkpoint()));
}

}  // namespace tdbd::simulation::checkpoint_keeper_test

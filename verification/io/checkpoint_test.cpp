#include "io/checkpoint.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/read_file.hpp"
#include "io/whole_file.hpp"
#include "verification/battery/out_of_memory.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/bit/files/mesh_bit.hpp"

namespace tdbd::checkpoint_file_test {

namespace fs = std::filesystem;

using bit::test_folder;

CheckpointFile any_file() {
  const auto text = *rc::gen::string<std::string>();
  ArchiveWriter write;
  write(*rc::gen::container<std::vector<double>>(rc::gen::arbitrary<double>()), text);
  return {text + "v", {"0123456789abcdef", "[time]\nstep = 1\n"}, std::move(write).archive()};
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

RC_GTEST_PROP(CheckpointFile, reads_back_what_was_written, ()) {
  const fs::path path = test_folder() / "checkpoint.bin";
  const auto file = any_file();
  write_checkpoint_file(path, file);
  const auto read = read_checkpoint_file(path);
  RC_ASSERT(read.version == file.version);
  RC_ASSERT(read.of.hash == file.of.hash);
  RC_ASSERT(read.of.text == file.of.text);
  RC_ASSERT(read.state.bytes == file.state.bytes);
  RC_ASSERT(read.state.layout == file.state.layout);
  RC_ASSERT(!fs::exists(path.string() + ".partial"));
}

/// Cut off anywhere.
RC_GTEST_PROP(CheckpointFile, is_rejected_where_it_is_torn, ()) {
  const fs::path path = test_folder() / "checkpoint.bin";
  const auto file = any_file();
  write_checkpoint_file(path, file);
  const std::string whole = bytes_of(path);
  const auto kept = *rc::gen::inRange<std::size_t>(0, whole.size());
  write_bytes(path, whole.substr(0, kept));
  RC_ASSERT_THROWS_AS(read_checkpoint_file(path), RunError);
}

/// One byte changed anywhere.
RC_GTEST_PROP(CheckpointFile, is_rejected_where_it_was_changed, ()) {
  const fs::path path = test_folder() / "checkpoint.bin";
  const auto file = any_file();
  write_checkpoint_file(path, file);
  std::string bytes = bytes_of(path);
  const auto place = *rc::gen::inRange<std::size_t>(0, bytes.size());
  bytes[place] = static_cast<char>(bytes[place] ^ *rc::gen::inRange(1, 256));
  write_bytes(path, bytes);
  RC_ASSERT_THROWS_AS(read_checkpoint_file(path), RunError);
}

TEST(CheckpointFile, is_told_from_other_files) {
  const fs::path path = test_folder() / "checkpoint.bin";
  EXPECT_THROW(read_checkpoint_file(path), RunError) << "no file";
  write_bytes(path, "solid of a mesh");
  EXPECT_THROW(read_checkpoint_file(path), RunError);
}

const CheckpointFile some_file{"v", {"hash", "[time]\n"}, {}};

/// On a disk that is full the old one stays, and what was begun is taken away.
TEST(CheckpointFile, that_does_not_come_to_the_disk_is_none) {
  const fs::path path = test_folder() / "checkpoint.bin";
  write_checkpoint_file(path, some_file);
  const std::string before = bytes_of(path);
  const auto told = battery::in_a_process([&]() -> std::optional<bool> {
    if (!battery::refuse_call(__NR_fsync, ENOSPC)) return std::nullopt;
    try {
      write_checkpoint_file(path, {"w", {"hash", "[time]\n"}, {}});
    } catch (const RunError& e) {
      return std::string(e.what()) ==
             "cannot write " + path.string() + ".partial: No space left on device";
    }
    return false;
  });
  if (!told) GTEST_SKIP() << "this system refuses no call";
  EXPECT_TRUE(*told);
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_FALSE(fs::exists(path.string() + ".partial"));
}

/// Also without standard input, where they get the number 0.
TEST(CheckpointFile, leaves_nothing_open) {
  const fs::path path = test_folder() / "checkpoint.bin";
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const int kept = dup(STDIN_FILENO);
  close(STDIN_FILENO);
  const auto before = open_files();
  std::string failure;
  try {
    write_checkpoint_file(path, some_file);
  } catch (const std::exception& e) {
    failure = e.what();
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_EQ(failure, "");
  if (kept >= 0) {
    dup2(kept, STDIN_FILENO);
    close(kept);
  }
}

/// A file without its seal, and one that is sealed and something else.
TEST(CheckpointFile, needs_its_seal_and_its_kind) {
  const fs::path path = test_folder() / "checkpoint.bin";
  write_sealed(path, "tdbd checkpoint 2\nof an earlier version");
  EXPECT_THROW(read_checkpoint_file(path), RunError);
  write_checkpoint_file(path, some_file);
  const std::string whole = bytes_of(path);
  write_bytes(path, whole.substr(0, whole.rfind("tdbd seal")));
  EXPECT_THROW(read_checkpoint_file(path), RunError);
}

/// What reading these values from a checkpoint of some values throws; empty: it was read.
template <class... T>
std::string refusal(const CaseMark& c, T... values) {
  const fs::path path = test_folder() / "checkpoint.bin";
  write_checkpoint(path, {"hash", "[time]\nstep = 1\n"}, 1.5, 3L);
  try {
    read_checkpoint(path, c, values...);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(Checkpoint, is_of_one_case_and_one_list_of_values) {
  const CaseMark c{"hash", "[time]\nstep = 1\n"};
  EXPECT_EQ(refusal(c, 0.0, 0L), "");
  for (const std::string& text : {refusal(c, 0.0), refusal(c, 0.0, 0L, 0L), refusal(c, 0L, 0.0)})
    EXPECT_NE(text.find("does not hold the state of this version of tdbd"), std::string::npos)
        << text;
  const std::string text = refusal({"other", "[time]\nstep = 2\n"}, 0.0, 0L);
  EXPECT_NE(text.find("the case has changed since: [time] found step = 2, expected step = 1"),
            std::string::npos)
      << text;
}

/// A checkpoint whose memory cannot be had ends with an exception, with nothing left behind.
TEST(MemoryLeftForCheckpoints, is_missed_without_a_crash) {
  const fs::path path = test_folder() / "checkpoint.bin";
  const auto large = [] {
    return CheckpointFile{"v", {"hash", "[time]\n"}, {std::string(2'000'000, 'x'), 0}};
  };
  EXPECT_TRUE(battery::throws_for_want_of_memory(
      large, [&](const CheckpointFile& f) { write_checkpoint_file(path, f); }));
  EXPECT_TRUE(fs::is_empty(path.parent_path()));
  write_checkpoint_file(path, large());
  EXPECT_TRUE(battery::throws_for_want_of_memory(
      large, [&](const CheckpointFile&) { read_checkpoint_file(path); }));
}

}  // namespace tdbd::checkpoint_file_test

namespace tdbd::checkpoint_keeper_test {

using bit::test_folder;

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

TEST(CheckpointKeeper, continues_after_the_rows_of_the_checkpoint) {
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
  EXPECT_EQ(warnings[0],
            "no room; the run continues and can be resumed from its last good checkpoint");
  EXPECT_EQ(text_of(folder.checkpoint()), "good");
  EXPECT_FALSE(fs::exists(folder.previous_checkpoint()));
}

}  // namespace tdbd::checkpoint_keeper_test

#include "io/whole_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "io/output_folder.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/core/temporary_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::whole_file_test {

namespace fs = std::filesystem;

fs::path some_file(const std::string& name) {
  const fs::path path = tdbd::temporary_folder() + "tdbd_whole_" + name;
  fs::remove_all(path);
  return path;
}

template <class F>
std::string message_of(F f) {
  try {
    f();
  } catch (const RunError& e) {
    return e.what();
  }
  return "nothing";
}

TEST(AtomicFile, appears_with_its_commit_and_not_before) {
  const fs::path path = some_file("late");
  AtomicFile file(path);
  file.stream() << "bytes";
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::exists(partial_path(path)));
  file.commit();
  EXPECT_EQ(read_file(path, "a file"), "bytes");
  EXPECT_FALSE(fs::exists(partial_path(path)));
}

TEST(AtomicFile, without_commit_leaves_what_was_there) {
  const fs::path path = some_file("kept");
  write_text(path, "old");
  { AtomicFile(path).stream() << "new"; }
  EXPECT_EQ(read_file(path, "a file"), "old");
  EXPECT_FALSE(fs::exists(partial_path(path)));
}

/// Longer first: nothing of an older partial file stays.
TEST(AtomicFile, overwrites_an_older_partial_file) {
  const fs::path path = some_file("anew");
  write_text(partial_path(path), "of a run that was killed");
  write_text(path, "short");
  EXPECT_EQ(read_file(path, "a file"), "short");
}

TEST(AtomicFile, reports_which_file_and_why) {
  const fs::path path = "/proc/no/such.csv";
  EXPECT_EQ(message_of([&] { AtomicFile file(path); }),
            "cannot write /proc/no/such.csv: No such file or directory");
  EXPECT_EQ(message_of([&] { flush_to_disk(path); }),
            "cannot write /proc/no/such.csv: No such file or directory");
  EXPECT_EQ(message_of([&] { rename_partial(path); }),
            "cannot write /proc/no/such.csv: No such file or directory");
}

/// If there is no disk behind a file, the system reports it, and closing the file does not hide the
/// error.
TEST(AtomicFile, that_the_system_cannot_put_on_a_disk_is_told) {
  EXPECT_EQ(message_of([] { flush_to_disk("/dev/null"); }),
            "cannot write /dev/null: Invalid argument");
}

/// After a successful call errno is meaningless: it contains an earlier error.
TEST(AtomicFile, does_not_believe_an_old_error) {
  const fs::path path = some_file("old_error");
  write_text(path, "bytes");
  errno = EACCES;
  EXPECT_EQ(message_of([&] { flush_to_disk(path); }), "nothing");
  AtomicFile file(path);
  file.stream().setstate(std::ios::badbit);
  errno = EACCES;
  EXPECT_EQ(message_of([&] { file.commit(); }),
            "cannot write " + path.string() + ": a write failed");
}

/// It does not touch the partial file of the next writer.
TEST(AtomicFile, that_is_committed_touches_nothing_more) {
  const fs::path path = some_file("twice");
  std::optional<AtomicFile> first(std::in_place, path);
  first->commit();
  AtomicFile second(path);
  second.stream() << "second";
  first.reset();
  EXPECT_EQ(message_of([&] { second.commit(); }), "nothing");
  EXPECT_EQ(read_file(path, "a file"), "second");
}

/// As on full disks and over networks: the message is that of the first call that fails.
TEST(AtomicFile, reports_why_it_was_not_written) {
  const fs::path path = some_file("lost");
  write_text(path, "bytes");
  const std::string told = "cannot write " + path.string() + ": ";
  const auto tells = [&](const std::string& reason, bool syncs) {
    return battery::in_a_process([&]() -> std::optional<bool> {
      if (!syncs && !battery::refuse_call(__NR_fsync, ENOSPC)) return std::nullopt;
      if (!battery::refuse_call(__NR_close, EIO)) return std::nullopt;
      return message_of([&] { flush_to_disk(path); }) == told + reason;
    });
  };
  const auto full = tells("No space left on device", false),
             lost = tells("Input/output error", true);
  if (!full || !lost) GTEST_SKIP() << "this system refuses no call";
  EXPECT_TRUE(*full);
  EXPECT_TRUE(*lost);
}

/// A program without standard input gets its number, 0, for the next file that it opens.
TEST(AtomicFile, and_a_folder_lock_may_have_the_number_0) {
  const fs::path path = some_file("zero");
  write_text(path, "bytes");
  const int kept = dup(STDIN_FILENO);
  close(STDIN_FILENO);
  EXPECT_EQ(message_of([&] { flush_to_disk(path); }), "nothing");
  EXPECT_EQ(message_of([&] { FolderLock lock(path.parent_path()); }), "nothing");
  if (kept >= 0) {
    dup2(kept, STDIN_FILENO);
    close(kept);
  }
}

}  // namespace tdbd::whole_file_test

namespace tdbd::seal_test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

RC_GTEST_PROP(Seal, lets_pass_what_was_sealed, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  require_seal(path);
  RC_ASSERT(read_file(path, "a file").starts_with(bytes));
}

RC_GTEST_PROP(Seal, rejects_any_change_of_a_byte, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  std::string changed = read_file(path, "a file");
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, changed.size());
  changed[i] = static_cast<char>(changed[i] ^ *rc::gen::inRange(1, 256));
  write(path, changed);
  RC_ASSERT_THROWS_AS(require_seal(path), RunError);
}

RC_GTEST_PROP(Seal, rejects_what_is_torn, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  fs::resize_file(path, *rc::gen::inRange<std::uintmax_t>(0, fs::file_size(path)));
  RC_ASSERT_THROWS_AS(require_seal(path), RunError);
}

TEST(Seal, of_a_file_that_is_not_there_is_rejected) {
  EXPECT_THROW(require_seal("/no/such/file"), RunError);
  EXPECT_THROW(seal_file("/no/such/file"), RunError);
}

}  // namespace
}  // namespace tdbd::seal_test

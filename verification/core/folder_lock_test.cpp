#include "core/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <optional>

#include "core/error.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::folder_lock_test {

namespace fs = std::filesystem;

fs::path some_folder(const std::string& name) {
  const fs::path path = tdbd::temporary_folder() + "tdbd_lock_" + name;
  fs::create_directories(path);
  return path;
}

TEST(FolderLock, holds_a_folder_for_one_at_a_time) {
  const fs::path folder = some_folder("one"), other = some_folder("other");
  std::optional<FolderLock> lock(std::in_place, folder);
  EXPECT_THROW(FolderLock second(folder), InputError);
  EXPECT_NO_THROW(FolderLock third(other));
  lock.reset();
  EXPECT_NO_THROW(FolderLock fourth(folder));
}

/// A refusal keeps no file open.
TEST(FolderLock, that_is_refused_leaves_nothing_open) {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const fs::path folder = some_folder("open");
  const FolderLock lock(folder);
  const auto before = open_files();
  EXPECT_THROW(FolderLock second(folder), InputError);
  EXPECT_EQ(open_files(), before);
}

TEST(FolderLock, of_a_folder_that_cannot_be_opened_is_no_lock) {
  EXPECT_THROW(FolderLock lock(some_folder("gone") / "missing"), RunError);
}

TEST(FolderLock, leaves_no_file_and_ends_with_a_killed_process) {
  const fs::path folder = some_folder("killed");
  const pid_t child = fork();
  if (child == 0) {
    const FolderLock lock(folder);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_NO_THROW(FolderLock lock(folder));
  EXPECT_TRUE(fs::is_empty(folder));
}

/// On a network's file system that has no locks. Runs go there too: without a lock is better than not at all.
TEST(FolderLock, is_not_asked_for_where_a_file_system_has_none) {
  const fs::path folder = some_folder("without");
  const auto goes = battery::in_a_process([&]() -> std::optional<bool> {
    if (!battery::refuse_call(__NR_flock, ENOLCK)) return std::nullopt;
    try {
      const FolderLock lock(folder);
    } catch (const std::exception&) {
      return false;
    }
    return true;
  });
  if (!goes) GTEST_SKIP() << "this system refuses no call";
  EXPECT_TRUE(*goes);
}

}  // namespace tdbd::folder_lock_test

#include "core/read_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/error.hpp"
#include "verification/core/temporary_file.hpp"

namespace tdbd::read_file_test {

namespace fs = std::filesystem;

std::string refusal(const fs::path& path) {
  try {
    read_file(path, "a table");
  } catch (const InputError& e) {
    return e.what();
  }
  return "not refused";
}

TEST(ReadFile, gives_every_byte) {
  const std::string bytes("a\0b\r\n\xff", 6);
  EXPECT_EQ(read_file(write_temporary(".txt", bytes), "a text"), bytes);
  EXPECT_EQ(read_file(write_temporary(".txt", ""), "a text"), "");
}

/// The system reports their size as 0.
TEST(ReadFile, reads_files_without_a_known_size) {
  EXPECT_FALSE(read_file("/proc/self/status", "a text").empty());
}

/// The kernel reports a page for some that contain a line.
TEST(ReadFile, gives_no_more_than_a_file_holds) {
  const fs::path file = "/sys/devices/system/cpu/online";
  std::error_code none;
  if (fs::file_size(file, none) < 1000 || none) GTEST_SKIP() << "this system has no such file";
  const std::string text = read_file(file, "a text");
  EXPECT_LT(text.size(), 1000u);
  EXPECT_EQ(text.back(), '\n');
}

/// The machine lacks something: the file is not at fault.
TEST(ReadFile, of_a_program_with_too_many_open_files_is_no_mistake_of_the_input) {
  const std::string file = write_temporary(".txt", "text");
  rlimit usual{};
  getrlimit(RLIMIT_NOFILE, &usual);
  const rlimit none{0, usual.rlim_max};
  setrlimit(RLIMIT_NOFILE, &none);
  std::string told;
  try {
    read_file(file, "a table");
  } catch (const RunError& e) {
    told = e.what();
  } catch (const InputError&) {
    told = "the input's";
  }
  setrlimit(RLIMIT_NOFILE, &usual);
  EXPECT_EQ(told, file + ": cannot open: Too many open files");
}

/// A pipe waits for its writer, and /dev/zero has no end.
TEST(ReadFile, rejects_pipes_devices_folders_and_loops_of_links_unopened) {
  const std::string pipe = write_temporary(".pipe", "");
  fs::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), pipe + ": found no regular file, expected a table");
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: found no regular file, expected a table");
  EXPECT_EQ(refusal("/proc"), "/proc: found a folder, expected a table");
  EXPECT_EQ(refusal("/no/table"), "/no/table: found no such file, expected a table");
  const std::string loop = write_temporary(".loop", "");
  fs::remove(loop);
  fs::create_symlink(loop, loop);
  EXPECT_EQ(refusal(loop), loop + ": found Too many levels of symbolic links, expected a table");
  fs::remove(loop);
}

}  // namespace tdbd::read_file_test

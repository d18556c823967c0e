#include "core/plain_path.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "core/read_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::plain_path_test {

namespace fs = std::filesystem;

TEST(PlainPath, names_the_same_file_without_what_stands_in_its_folders_names) {
  for (const std::string name : {" ", "a\\b", "http:", "#mode=bytes"}) {
    const fs::path folder = tdbd::temporary_folder() + "tdbd_plain/" + name;
    fs::create_directories(folder);
    const PlainPath plain(folder / "history.nc");
    EXPECT_EQ(std::string(plain.c_str()).find_first_of(" \\:#"), std::string::npos);
    std::ofstream(plain.c_str()) << name;
    EXPECT_EQ(read_file(folder / "history.nc", "a text"), name);
  }
}

/// Also without standard input, where the folder gets the number 0.
TEST(PlainPath, leaves_no_folder_open) {
  const int kept = dup(STDIN_FILENO);
  for (const bool has_input : {true, false}) {
    if (!has_input) close(STDIN_FILENO);
    const int before = dup(STDERR_FILENO);
    close(before);
    { const PlainPath plain(fs::path(tdbd::temporary_folder()) / "history.nc"); }
    const int after = dup(STDERR_FILENO);
    close(after);
    EXPECT_EQ(after, before) << has_input;
  }
  if (kept >= 0) {
    dup2(kept, STDIN_FILENO);
    close(kept);
  }
}

TEST(PlainPath, is_the_path_where_there_is_no_folder) {
  EXPECT_STREQ(PlainPath("/no/folder/history.nc").c_str(), "/no/folder/history.nc");
}

}  // namespace tdbd::plain_path_test

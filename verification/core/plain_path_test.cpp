#include "core/plain_path.hpp"

#include <gtest/gtest.h>

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

TEST(PlainPath, is_the_path_where_there_is_no_folder) {
  EXPECT_STREQ(PlainPath("/no/folder/history.nc").c_str(), "/no/folder/history.nc");
}

}  // namespace tdbd::plain_path_test

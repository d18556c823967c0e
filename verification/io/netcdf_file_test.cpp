#include "io/netcdf_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "verification/bit/files/mesh_bit.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::netcdf_file_test {

namespace fs = std::filesystem;
using bit::test_folder;

fs::path written_file() {
  const fs::path path = test_folder() / "table.nc";
  NetcdfFile nc(path, NetcdfFile::Use::create);
  const int row = nc.dimension("row", 2), xyz = nc.dimension("xyz", 3);
  nc.attribute(NetcdfFile::global, "title", "a table");
  nc.attribute(NetcdfFile::global, "depth_m", 0.1);
  const int place = nc.variable({"place", NetcdfType::real, {row, xyz}, "m", "where"});
  const int kind = nc.variable({"kind", NetcdfType::whole, {row}, "", ""});
  nc.put(place, std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.5});
  nc.put(kind, std::vector{7, 8});
  nc.close();
  return path;
}

TEST(NetcdfFile, reads_back_what_was_written) {
  const NetcdfFile nc(written_file(), NetcdfFile::Use::read);
  EXPECT_EQ(nc.text("title"), "a table");
  EXPECT_EQ(nc.number("depth_m"), 0.1);
  EXPECT_EQ(nc.length("row"), 2U);
  EXPECT_EQ(nc.reals("place", 6), (std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.5}));
  EXPECT_EQ(nc.wholes("kind", 2), (std::vector{7, 8}));
}

TEST(NetcdfFile, rejects_what_is_not_there) {
  const fs::path path = written_file();
  const NetcdfFile nc(path, NetcdfFile::Use::read);
  EXPECT_THROW(nc.text("name"), RunError);
  EXPECT_THROW(nc.number("width_m"), RunError);
  EXPECT_THROW(nc.length("column"), RunError);
  EXPECT_THROW(nc.reals("places", 6), RunError);
  EXPECT_THROW(nc.reals("place", 5), RunError) << "another number of values";
  EXPECT_THROW(NetcdfFile(path.parent_path() / "none.nc", NetcdfFile::Use::read), RunError);
}

TEST(NetcdfFile, names_the_file_that_it_cannot_write) {
  try {
    NetcdfFile nc("/no/folder/table.nc", NetcdfFile::Use::create);
    FAIL() << "written";
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "cannot write /no/folder/table.nc: No such file or directory");
  }
}

}  // namespace tdbd::netcdf_file_test

namespace tdbd::plain_path_test {

namespace fs = std::filesystem;

TEST(DescriptorPath, names_the_same_file_independently_of_folder_names) {
  for (const std::string name : {" ", "a\\b", "http:", "#mode=bytes"}) {
    const fs::path folder = tdbd::temporary_folder() + "tdbd_plain/" + name;
    fs::create_directories(folder);
    const DescriptorPath plain(folder / "history.nc");
    EXPECT_EQ(std::string(plain.c_str()).find_first_of(" \\:#"), std::string::npos);
    std::ofstream(plain.c_str()) << name;
    EXPECT_EQ(read_file(folder / "history.nc", "a text"), name);
  }
}

/// Also without standard input, where the folder gets the number 0.
TEST(DescriptorPath, leaves_no_folder_open) {
  const int kept = dup(STDIN_FILENO);
  for (const bool has_input : {true, false}) {
    if (!has_input) close(STDIN_FILENO);
    const int before = dup(STDERR_FILENO);
    close(before);
    { const DescriptorPath plain(fs::path(tdbd::temporary_folder()) / "history.nc"); }
    const int after = dup(STDERR_FILENO);
    close(after);
    EXPECT_EQ(after, before) << has_input;
  }
  if (kept >= 0) {
    dup2(kept, STDIN_FILENO);
    close(kept);
  }
}

TEST(DescriptorPath, is_the_path_where_there_is_no_folder) {
  EXPECT_STREQ(DescriptorPath("/no/folder/history.nc").c_str(), "/no/folder/history.nc");
}

}  // namespace tdbd::plain_path_test

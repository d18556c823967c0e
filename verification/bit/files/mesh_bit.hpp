#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "mesh/files/files.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::bit {

/// An empty folder of this test's own.
inline std::filesystem::path test_folder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(tdbd::temporary_folder()) /
                      (std::string(info->test_suite_name()) + "_" + info->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path.string();
}

/// bit.toml of one part, part.ply, with more lines of its table.
inline std::string write_one_part_bit(const std::filesystem::path& folder,
                                      const mesh::TriangleMesh& part, const std::string& lines) {
  mesh::write_mesh(folder / "part.ply", part);
  return write_file(folder / "bit.toml",
                    "name = \"tool\"\n[[parts]]\nname = \"tool\"\nfile = \"part.ply\"\n" + lines);
}

}  // namespace tdbd::bit

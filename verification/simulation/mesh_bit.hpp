#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "mesh/files/files.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation {

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

/// A case that drills with a bit file: `rock` and `time` are the lines of these tables.
inline std::string write_case(const std::filesystem::path& folder, const std::string& bit_file,
                              const std::string& rock, const std::string& time) {
  return write_file(
      folder / "case.toml",
      "[bit]\nfile = \"" + bit_file + "\"\n[rock]\n" + rock +
          "\n[motion]\nrotary_speed = \"120 rpm\"\nrate_of_penetration = \"60 m/h\"\n" +
          "[time]\n" + time + "\n");
}

/// bit.toml of one part, part.ply, with more lines of its table.
inline std::string write_one_part_bit(const std::filesystem::path& folder,
                                      const mesh::TriangleMesh& part, const std::string& lines) {
  mesh::write_mesh(folder / "part.ply", part);
  return write_file(folder / "bit.toml",
                    "name = \"tool\"\n[[parts]]\nname = \"tool\"\nfile = \"part.ply\"\n" + lines);
}

}  // namespace tdbd::simulation

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace tdbd::simulation {

/// Every file of a folder but timing.json, by its name.
inline std::map<std::string, std::string> result_files(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename() == "timing.json") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

inline void expect_same_result_files(const std::filesystem::path& a,
                                     const std::filesystem::path& b) {
  const auto x = result_files(a), y = result_files(b);
  for (const auto& [name, bytes] : x)
    EXPECT_TRUE(y.contains(name) && y.at(name) == bytes) << name << " differs, or is missing";
  for (const auto& [name, bytes] : y) EXPECT_TRUE(x.contains(name)) << name << " is left over";
}

}  // namespace tdbd::simulation

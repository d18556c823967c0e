#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace tdbd {

/// A folder that only this process uses, removed when it ends; the path ends with a slash. Tests run in parallel, each
/// in its own process.
inline const std::string& temporary_folder() {
  struct Folder {
    std::string path = ::testing::TempDir() + "tdbd_" + std::to_string(getpid()) + "/";
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace tdbd

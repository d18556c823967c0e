#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace tdbd {

/// A folder of this process alone, removed when it ends; with a slash at its end. Tests run side by
/// side, each in a process of its own.
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

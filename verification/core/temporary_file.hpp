#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "verification/core/temporary_folder.hpp"

namespace tdbd {

/// Writes a file that only this test uses into the temporary folder and returns its path.
inline std::string write_temporary(const std::string& suffix, const std::string& content) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string path =
      tdbd::temporary_folder() + info->test_suite_name() + "_" + info->name() + suffix;
  std::ofstream(path) << content;
  return path;
}

}  // namespace tdbd

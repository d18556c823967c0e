#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"

namespace tdbd {

/// @file The messages about a wrong file.

/// One test: a file's text, what a program reads of it, the one line of message this must give
/// (FILE stands for the path).
struct Mistake {
  std::string toml;
  void (*read)(Config&);
  std::string message;
  std::vector<std::string> overrides = {};
};

inline std::string finish_message(const Config& config) {
  try {
    config.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline void expect_message(const Mistake& mistake) {
  const std::string path = write_temporary(".toml", mistake.toml);
  std::string expected = mistake.message;
  if (expected.rfind("FILE", 0) == 0) expected.replace(0, 4, path);
  Config config = Config::read_file(path, mistake.overrides);
  mistake.read(config);
  EXPECT_EQ(finish_message(config), expected);
}

inline std::string read_failure(const std::string& path) {
  try {
    Config::read_file(path, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace tdbd

#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace tdbd::battery {

/// What a command returned.
struct Outcome {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string out, err;
};

/// The conditions under which a command runs.
struct Surroundings {
  std::filesystem::path standard_output = {};  ///< empty: captured
  long largest_file = -1;                      ///< bytes that a file may have; -1: no limit
  std::filesystem::path signal_after = {};  ///< send `signal` once this file exists; empty: never
  double signal_after_seconds = -1.0;       ///< or after so many seconds; < 0: never
  int signal = SIGINT;
  int second_signal = 0;    ///< sent with it, both before the program runs on; 0: none
  bool has_threads = true;  ///< false: the system starts none; 126: it takes no such rule
};

/// Runs the built program with these arguments and waits for it.
Outcome run_tdbd(const std::vector<std::string>& arguments, const Surroundings& around = {});

}  // namespace tdbd::battery

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "battery/run_tdbd.hpp"

namespace tdbd::app {

/// A folder of one test, empty at the start, for the inputs and results of the program.
class CaseFolder {
 public:
  CaseFolder();

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const;
  /// Replaces a text of the file; fails the test if the file does not contain it.
  void edit(const std::string& name, const std::string& from, const std::string& to) const;

  battery::Outcome check(const std::vector<std::string>& more = {}) const;

 private:
  std::filesystem::path folder_;
};

std::string read(const std::filesystem::path& file);

/// A PLY file without its comments: a rock without the case and the step that made it.
std::string read_unstamped(const std::filesystem::path& file);

/// Names of all files below a folder, sorted.
std::vector<std::string> files_below(const std::filesystem::path& folder);

/// Every file of two results but the times, at least `least` of them.
void expect_same_results(const std::filesystem::path& a, const std::filesystem::path& b,
                         std::size_t least);

/// Lines of a file.
long lines_of(const std::filesystem::path& file);

/// xarray opens the history and finds so many rows.
bool history_opens(const std::filesystem::path& file, long rows);

/// The input is refused: exit code 2, this message and nothing else.
void expect_refusal(const battery::Outcome& o, const std::string& message);

}  // namespace tdbd::app

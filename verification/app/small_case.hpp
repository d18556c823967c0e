#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "battery/run_tdbd.hpp"

namespace tdbd::app {

/// A folder of one test with a case that runs in a blink: a bit of six cutters in a coarse rock.
/// Files: case.toml, bit.toml, bit.csv.
class SmallCase {
 public:
  SmallCase();

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const;
  /// Replaces a text that stands in the file; fails the test when it does not.
  void edit(const std::string& name, const std::string& from, const std::string& to) const;

  /// `tdbd run case.toml -o out ...`
  battery::Outcome run(std::vector<std::string> more = {}, const std::string& out = "out",
                       const battery::Surroundings& around = {}) const;
  battery::Outcome check(const std::vector<std::string>& more = {}) const;

 private:
  std::filesystem::path folder_;
};

std::string read(const std::filesystem::path& file);

/// Names of all files below a folder, sorted.
std::vector<std::string> files_below(const std::filesystem::path& folder);

/// The input is refused: exit code 2, this message for this file alone, nothing written.
void expect_refused(const SmallCase& c, const std::string& message);

}  // namespace tdbd::app

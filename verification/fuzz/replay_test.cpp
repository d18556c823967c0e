#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "core/read_file.hpp"
#include "fuzz/fuzz_target.hpp"

/// Replays the inputs that the fuzzers found, in the build that users have (README.md of this folder).
namespace tdbd::fuzz {

void PrintTo(const FuzzTarget& target, std::ostream* out) { *out << target.name; }

namespace replay_test {

namespace fs = std::filesystem;

std::vector<fs::path> corpus_of(const FuzzTarget& target) {
  const fs::path folder = fs::path(TDBD_FUZZ_CORPUS) / target.name;  // unpacked by the build
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class Fuzz : public ::testing::TestWithParam<FuzzTarget> {};

/// Each input is read, or rejected with the error that the reader's header names.
TEST_P(Fuzz, replays_the_corpus) {
  const std::vector<fs::path> files = corpus_of(GetParam());
  EXPECT_GE(files.size(), 2u);
  for (const fs::path& file : files) {
    const std::string bytes = read_file(file, "an input of the corpus");
    EXPECT_NO_THROW(GetParam().take(bytes)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz,
                         ::testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace replay_test
}  // namespace tdbd::fuzz

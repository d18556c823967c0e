#include "sweep/table/journal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/error.hpp"
#include "verification/battery/generators.hpp"
#include "verification/sweep/small_design.hpp"

namespace {
int interruptions = 0;          ///< of calls of write() to come
ssize_t when_interrupted = -1;  ///< what they return
}  // namespace

/// Replaces the function of the system in the whole program.
extern "C" ssize_t write(int file, const void* bytes, size_t count) {
  if (interruptions == 0) return syscall(SYS_write, file, bytes, count);
  --interruptions;
  errno = EINTR;
  return when_interrupted;
}

namespace tdbd::sweep::journal_test {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

PointRecord record(double x) {
  return {{PointStatus::done, "hash", "", {x, std::numeric_limits<double>::quiet_NaN()}, false},
          0.25};
}

/// Numbers are read back bitwise identical, messages with any characters.
TEST(Journal, gives_back_what_it_took) {
  const fs::path folder = empty_folder("journal");
  PointRecord failed{{PointStatus::failed, "", "a \"line\"\nand \xff another", {0.1 + 0.2}, false},
                     1.0};
  {
    Journal journal(folder / "1-of-2");
    journal.add("a", record(1.0 / 3.0));
    journal.add("b", failed);
  }
  Journal(folder / "2-of-2").add("c", record(-0.0));
  const PointRecords read = read_journals(folder);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read.at("a").outcome.figures[0], 1.0 / 3.0);
  EXPECT_TRUE(std::isnan(read.at("a").outcome.figures[1]));
  EXPECT_EQ(read.at("a").seconds, 0.25);
  EXPECT_EQ(read.at("b").outcome.status, PointStatus::failed);
  EXPECT_EQ(read.at("b").outcome.message, "a \"line\"\nand \xef\xbf\xbd another");
  EXPECT_TRUE(std::signbit(read.at("c").outcome.figures[0]));
}

/// Cut off anywhere: every whole line is kept, and the next one to write cuts off the rest.
RC_GTEST_PROP(Journal, loses_only_the_torn_line, ()) {
  const fs::path folder = empty_folder("torn");
  const int count = *battery::integer(1, 5);
  std::vector<std::size_t> ends;
  const fs::path file = folder / "1-of-1" / "points.jsonl";
  for (int i = 0; i < count; ++i) {
    Journal(folder / "1-of-1").add(std::to_string(i), record(i));
    ends.push_back(bytes_of(file).size());
  }
  const std::string all = bytes_of(file);
  const auto cut = static_cast<std::size_t>(*battery::integer(0, static_cast<int>(all.size())));
  put(file, all.substr(0, cut));
  const auto whole = static_cast<std::size_t>(
      std::ranges::count_if(ends, [&](std::size_t e) { return e <= cut; }));
  RC_ASSERT(read_journals(folder).size() == whole);
  Journal(folder / "1-of-1").add("new", record(7.0));
  RC_ASSERT(read_journals(folder).size() == whole + 1);
}

TEST(Journal, rejects_a_line_that_was_changed) {
  const fs::path folder = empty_folder("changed");
  Journal(folder / "1-of-1").add("a", record(1.5));
  Journal(folder / "1-of-1").add("b", record(2.5));
  const fs::path file = folder / "1-of-1" / "points.jsonl";
  std::string bytes = bytes_of(file);
  bytes[bytes.find("1.5")] = '7';
  put(file, bytes);
  try {
    read_journals(folder);
    FAIL();
  } catch (const RunError& e) {
    EXPECT_NE(
        std::string(e.what()).find("points.jsonl:1: found a line that is not as it was written"),
        std::string::npos);
  }
}

/// Two shards may have run the same point: the first by name counts, in whatever order a disk has them.
/// No disk has the first before the second by chance for all these names, whichever was made first.
TEST(Journal, of_a_repeated_point_uses_the_first_folder) {
  for (int shards = 2; shards < 10; ++shards)
    for (const int made_first : {1, 2}) {
      const fs::path folder = empty_folder("twice");
      for (const int shard : {made_first, 3 - made_first})
        Journal(folder / fmt::format("{}-of-{}", shard, shards)).add("a", record(shard));
      EXPECT_EQ(read_journals(folder).at("a").outcome.figures[0], 1.0);
    }
}

/// A line that does not fit is taken back, as where a disk is full.
TEST(Journal, keeps_no_half_of_a_line_that_cannot_be_written) {
  const fs::path folder = empty_folder("full"), file = folder / "1-of-1" / "points.jsonl";
  Journal journal(folder / "1-of-1");
  journal.add("a", record(1.0));
  const std::string before = bytes_of(file);
  const auto of_signal = std::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit tight{before.size() + 10, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  EXPECT_THROW(journal.add("b", record(2.0)), RunError);
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, of_signal);
  EXPECT_EQ(bytes_of(file), before);
  journal.add("c", record(3.0));
  EXPECT_EQ(read_journals(folder).size(), 2u);
}

/// A signal may come before the first byte is written, on some file systems: the line is then written again.
TEST(Journal, writes_a_line_whose_writing_was_interrupted) {
  const fs::path folder = empty_folder("interrupted");
  Journal journal(folder / "1-of-1");
  interruptions = 3;
  journal.add("a", record(1.0));
  EXPECT_EQ(interruptions, 0);
  EXPECT_EQ(read_journals(folder).size(), 1u);
}

/// Nothing was written, and no error came with it: the one that is left from before means nothing.
TEST(Journal, gives_up_where_nothing_can_be_written) {
  const fs::path folder = empty_folder("nothing");
  Journal journal(folder / "1-of-1");
  interruptions = 1;
  when_interrupted = 0;
  EXPECT_THROW(journal.add("a", record(1.0)), RunError);
  when_interrupted = -1;
  EXPECT_TRUE(read_journals(folder).empty());
}

TEST(Journal, has_one_writer) {
  const fs::path folder = empty_folder("writers");
  const Journal first(folder / "1-of-1");
  EXPECT_THROW(Journal(folder / "1-of-1"), InputError);
  EXPECT_NO_THROW(Journal(folder / "1-of-2"));
}

}  // namespace tdbd::sweep::journal_test

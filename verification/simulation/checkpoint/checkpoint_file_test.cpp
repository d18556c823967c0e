#include "simulation/checkpoint/checkpoint_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "verification/battery/out_of_memory.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::checkpoint_file_test {

namespace fs = std::filesystem;

CheckpointFile any_file() {
  const auto some = [](auto g) { return *rc::gen::container<std::vector<decltype(*g)>>(g); };
  CheckpointFile f{*rc::gen::string<std::string>(), "0123456789abcdef", "[time]\nstep = 1\n", {}};
  f.version += "v";  // NetCDF has no empty texts
  f.tape.names = "state\n";
  f.tape.reals = some(rc::gen::arbitrary<double>());
  f.tape.wholes = some(rc::gen::arbitrary<std::int64_t>());
  f.tape.ints = some(rc::gen::arbitrary<std::int32_t>());
  f.tape.bytes = some(rc::gen::arbitrary<std::uint8_t>());
  return f;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

RC_GTEST_PROP(CheckpointFile, reads_back_what_was_written, ()) {
  const fs::path path = test_folder() / "checkpoint.nc";
  const auto file = any_file();
  write_checkpoint_file(path, file);
  const auto read = read_checkpoint_file(path);
  RC_ASSERT(read.version == file.version);
  RC_ASSERT(read.case_text == file.case_text);
  RC_ASSERT(read.tape.names == file.tape.names);
  RC_ASSERT(read.tape.reals == file.tape.reals);
  RC_ASSERT(read.tape.wholes == file.tape.wholes);
  RC_ASSERT(read.tape.ints == file.tape.ints);
  RC_ASSERT(read.tape.bytes == file.tape.bytes);
  RC_ASSERT(!fs::exists(path.string() + ".partial"));
}

/// Cut off anywhere.
RC_GTEST_PROP(CheckpointFile, is_refused_where_it_is_torn, ()) {
  const fs::path path = test_folder() / "checkpoint.nc";
  auto file = any_file();
  file.tape.reals.push_back(1.0);
  write_checkpoint_file(path, file);
  const std::string whole = bytes_of(path);
  const auto kept = *rc::gen::inRange<std::size_t>(0, whole.size());
  write_bytes(path, whole.substr(0, kept));
  RC_ASSERT_THROWS_AS(read_checkpoint_file(path), RunError);
}

/// One byte changed anywhere, before NetCDF sees it.
RC_GTEST_PROP(CheckpointFile, is_refused_where_it_was_changed, ()) {
  const fs::path path = test_folder() / "checkpoint.nc";
  const auto file = any_file();
  write_checkpoint_file(path, file);
  std::string bytes = bytes_of(path);
  const auto place = *rc::gen::inRange<std::size_t>(0, bytes.size());
  bytes[place] = static_cast<char>(bytes[place] ^ *rc::gen::inRange(1, 256));
  write_bytes(path, bytes);
  RC_ASSERT_THROWS_AS(read_checkpoint_file(path), RunError);
}

TEST(CheckpointFile, is_told_from_other_files) {
  const fs::path path = test_folder() / "checkpoint.nc";
  EXPECT_THROW(read_checkpoint_file(path), RunError) << "no file";
  write_bytes(path, "solid of a mesh");
  EXPECT_THROW(read_checkpoint_file(path), RunError);
}

const CheckpointFile some_file{"v", "hash", "[time]\n", {}};

/// On a disk that is full the old one stays, and what was begun is taken away.
TEST(CheckpointFile, that_does_not_come_to_the_disk_is_none) {
  const fs::path path = test_folder() / "checkpoint.nc";
  write_checkpoint_file(path, some_file);
  const std::string before = bytes_of(path);
  const auto told = battery::in_a_process([&]() -> std::optional<bool> {
    if (!battery::refuse_call(__NR_fsync, ENOSPC)) return std::nullopt;
    try {
      write_checkpoint_file(path, {"w", "hash", "[time]\n", {}});
    } catch (const RunError& e) {
      return std::string(e.what()) ==
             "cannot write " + path.string() + ".partial: No space left on device";
    }
    return false;
  });
  if (!told) GTEST_SKIP() << "this system refuses no call";
  EXPECT_TRUE(*told);
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_FALSE(fs::exists(path.string() + ".partial"));
}

/// Also without standard input, where they get the number 0.
TEST(CheckpointFile, leaves_nothing_open) {
  const fs::path path = test_folder() / "checkpoint.nc";
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const int kept = dup(STDIN_FILENO);
  close(STDIN_FILENO);
  const auto before = open_files();
  std::string failure;
  try {
    write_checkpoint_file(path, some_file);
  } catch (const std::exception& e) {
    failure = e.what();
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_EQ(failure, "");
  if (kept >= 0) {
    dup2(kept, STDIN_FILENO);
    close(kept);
  }
}

/// NetCDF would crash in the middle of its work: it is not even begun. Without the demand these would say that there is no such
/// folder.
TEST(MemoryLeftForCheckpoints, is_demanded_first) {
  const auto of_none = [] { return CheckpointFile{"v", "hash", "[time]\n", {}}; };
  EXPECT_TRUE(battery::throws_for_want_of_memory(
      of_none, [](const CheckpointFile& f) { write_checkpoint_file("/no/checkpoint.nc", f); }));
  EXPECT_TRUE(battery::throws_for_want_of_memory(
      of_none, [](const CheckpointFile&) { read_checkpoint_file("/no/checkpoint.nc"); }));
}

}  // namespace tdbd::simulation::checkpoint_file_test

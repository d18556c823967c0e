#include "io/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/bit/files/mesh_bit.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::output_folder_test {

namespace fs = std::filesystem;

/// A path of one test, at which there is nothing.
fs::path nothing_at(const std::string& name) {
  const fs::path path = tdbd::temporary_folder() + "tdbd_output_" + name;
  fs::remove_all(path);
  return path;
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::string refusal(const fs::path& path, Overwrite overwrite = Overwrite::no,
                    ResultKind kind = ResultKind::run,
                    const std::vector<std::string>& inputs = {}) {
  try {
    prepare(path, overwrite, inputs, kind);
  } catch (const InputError& e) {
    const std::string text = e.what(), start = "output folder " + path.string() + ": ";
    return text.rfind(start, 0) == 0 ? text.substr(start.size()) : text;
  }
  return "not refused";
}

/// A folder with files of these names, each with its own name in it.
fs::path folder_of(const std::string& name, const std::vector<std::string>& files) {
  const fs::path path = nothing_at(name);
  fs::create_directories(path / "frames");
  for (const std::string& file : files) write(path / file, file);
  return path;
}

/// The first line of what TDBD writes.
const std::string own_case = std::string(resolved_head) + "\n";
const std::string own_bit = "# A bit as the meshes of its parts.\nname = \"a\"\n";

TEST(OutputFolder, is_made_with_its_parents) {
  const OutputFolder folder = prepare(nothing_at("new") / "a" / "b", Overwrite::no);
  EXPECT_TRUE(fs::is_directory(folder.frames()));
  EXPECT_EQ(folder.frame("rock", 7), folder.path / "frames" / "rock-000007.vtp");
}

TEST(OutputFolder, that_is_empty_is_taken) {
  const fs::path path = nothing_at("empty");
  fs::create_directories(path);
  EXPECT_EQ(refusal(path), "not refused");
}

TEST(OutputFolder, whose_frames_are_a_file_is_rejected) {
  const fs::path path = nothing_at("frames");
  fs::create_directories(path);
  write(path / "frames", "notes");
  EXPECT_EQ(refusal(path, Overwrite::force), "its frames is a file");
  EXPECT_TRUE(fs::exists(path / "frames"));
}

TEST(OutputFolder, with_files_needs_force) {
  const fs::path path = folder_of("full", {"summary.json"});
  EXPECT_EQ(refusal(path), "exists; --force overwrites");
  EXPECT_TRUE(fs::exists(path / "summary.json"));
}

TEST(OutputFolder, force_removes_old_results_and_nothing_else) {
  const fs::path path = folder_of("force", {"summary.json", "history.nc", "frames/rock-000099.vtp",
                                            "notes.txt", "bit.stl", "bit.vtp", "analysis.json"});
  write(path / "case.toml", own_case);
  EXPECT_EQ(refusal(path, Overwrite::force), "not refused");
  for (const char* gone : {"summary.json", "history.nc", "case.toml", "frames/rock-000099.vtp"})
    EXPECT_FALSE(fs::exists(path / gone)) << gone;
  for (const char* kept : {"notes.txt", "bit.stl", "bit.vtp", "analysis.json"})
    EXPECT_TRUE(fs::exists(path / kept)) << kept;
}

TEST(OutputFolder, of_files_that_nothing_says_are_results_is_kept) {
  const fs::path path = folder_of("foreign", {"history.csv"});
  EXPECT_EQ(refusal(path, Overwrite::force),
            "holds history.csv, and no case.toml of TDBD beside it; take another folder");
  EXPECT_TRUE(fs::exists(path / "history.csv"));
  write(path / "convergence.json", "{}");
  EXPECT_EQ(refusal(path, Overwrite::force), "not refused");
  EXPECT_EQ(refusal(folder_of("failed", {"failure.txt"}), Overwrite::force), "not refused");
}

TEST(OutputFolder, of_a_bit_goes_whole_where_tdbd_wrote_it) {
  const fs::path path = folder_of("bit", {"analysis.json", "bit.stl", "summary.json"});
  write(path / "bit.toml", own_bit);
  EXPECT_EQ(refusal(path, Overwrite::force, ResultKind::bit, {path / "bit.toml"}),
            "holds the input " + (path / "bit.toml").string() + "; take another folder");
  fs::create_directories(path / "parts");
  write(path / "parts/face.ply", "ply");
  EXPECT_EQ(refusal(path, Overwrite::force, ResultKind::bit, {path / "parts/face.ply"}),
            "holds the input " + (path / "parts/face.ply").string() + "; take another folder");
  EXPECT_EQ(refusal(path, Overwrite::force, ResultKind::bit), "not refused");
  for (const char* gone : {"analysis.json", "bit.stl", "bit.toml"})
    EXPECT_FALSE(fs::exists(path / gone)) << gone;
  EXPECT_TRUE(fs::exists(path / "summary.json"));
}

TEST(OutputFolder, of_a_bit_that_a_user_wrote_is_kept) {
  const fs::path path = folder_of("users_bit", {"bit.stl"});
  EXPECT_EQ(refusal(path, Overwrite::force, ResultKind::bit),
            "holds bit.stl, and no bit.toml of TDBD beside it; take another folder");
  write(path / "bit.toml", "name = \"mine\"\n");
  EXPECT_EQ(refusal(path, Overwrite::force, ResultKind::bit),
            "its bit.toml is not one that TDBD wrote; take another folder");
  EXPECT_TRUE(fs::exists(path / "bit.stl"));
}

TEST(OutputFolder, that_another_command_writes_to_is_rejected) {
  const fs::path path = nothing_at("shared");
  const std::string in_use =
      "in use: another command writes to it; wait until it ends or choose another folder";
  {
    const OutputFolder first = prepare(path, Overwrite::no);
    write(first.path / "case.toml", own_case);
    EXPECT_EQ(refusal(path), in_use);
    EXPECT_EQ(refusal(path, Overwrite::force), in_use);
    EXPECT_TRUE(fs::exists(path / "case.toml"));
  }
  EXPECT_EQ(refusal(path, Overwrite::force), "not refused");
}

TEST(OutputFolder, that_is_claimed_keeps_its_older_result_until_it_is_cleared) {
  const fs::path path = folder_of("claimed", {"summary.json", "frames/rock-000099.vtp"});
  write(path / "case.toml", own_case);
  const OutputFolder folder = claim(path, Overwrite::force);
  EXPECT_TRUE(fs::exists(path / "summary.json"));
  EXPECT_THROW(claim(path, Overwrite::force), InputError);
  clear(folder);
  EXPECT_FALSE(fs::exists(path / "summary.json"));
  EXPECT_FALSE(fs::exists(path / "frames/rock-000099.vtp"));
}

TEST(OutputFolder, that_was_made_for_nothing_goes_again) {
  const fs::path path = nothing_at("unused");
  fs::create_directories(path);
  { const OutputFolder folder = claim(path / "a" / "b", Overwrite::no); }
  EXPECT_TRUE(fs::is_empty(path));
  { write(claim(path / "a" / "b", Overwrite::no).path / "notes.txt", "mine"); }
  EXPECT_TRUE(fs::exists(path / "a" / "b" / "notes.txt"));
}

TEST(OutputFolder, that_is_a_file_or_cannot_be_made_is_rejected) {
  const fs::path file = nothing_at("file");
  write(file, "x");
  EXPECT_EQ(refusal(file, Overwrite::force), "is a file");
  EXPECT_NE(refusal(file / "below"), "not refused");
  EXPECT_NE(refusal("/proc/tdbd"), "not refused");
}

}  // namespace tdbd::output_folder_test

namespace tdbd::folder_lock_test {

namespace fs = std::filesystem;

fs::path some_folder(const std::string& name) {
  const fs::path path = tdbd::temporary_folder() + "tdbd_lock_" + name;
  fs::create_directories(path);
  return path;
}

TEST(FolderLock, holds_a_folder_for_one_at_a_time) {
  const fs::path folder = some_folder("one"), other = some_folder("other");
  std::optional<FolderLock> lock(std::in_place, folder);
  EXPECT_THROW(FolderLock second(folder), InputError);
  EXPECT_NO_THROW(FolderLock third(other));
  lock.reset();
  EXPECT_NO_THROW(FolderLock fourth(folder));
}

/// A refusal keeps no file open.
TEST(FolderLock, that_is_rejected_leaves_nothing_open) {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const fs::path folder = some_folder("open");
  const FolderLock lock(folder);
  const auto before = open_files();
  EXPECT_THROW(FolderLock second(folder), InputError);
  EXPECT_EQ(open_files(), before);
}

TEST(FolderLock, of_a_folder_that_cannot_be_opened_is_no_lock) {
  EXPECT_THROW(FolderLock lock(some_folder("gone") / "missing"), RunError);
}

TEST(FolderLock, leaves_no_file_and_ends_with_a_killed_process) {
  const fs::path folder = some_folder("killed");
  const pid_t child = fork();
  if (child == 0) {
    const FolderLock lock(folder);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_NO_THROW(FolderLock lock(folder));
  EXPECT_TRUE(fs::is_empty(folder));
}

/// On a network's file system that has no locks. Runs go there too: without a lock is better than not at all.
TEST(FolderLock, is_skipped_where_the_file_system_has_no_locks) {
  const fs::path folder = some_folder("without");
  const auto goes = battery::in_a_process([&]() -> std::optional<bool> {
    if (!battery::refuse_call(__NR_flock, ENOLCK)) return std::nullopt;
    try {
      const FolderLock lock(folder);
    } catch (const std::exception&) {
      return false;
    }
    return true;
  });
  if (!goes) GTEST_SKIP() << "this system refuses no call";
  EXPECT_TRUE(*goes);
}

}  // namespace tdbd::folder_lock_test

namespace tdbd::old_parts_test {

using bit::test_folder;
using bit::write_file;

namespace fs = std::filesystem;

/// Files below a folder, by their names from there.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

/// A bit as `tdbd bit` exports it.
void export_to(const fs::path& folder, const std::string& bit_file, const std::string& format) {
  const bit::Bit bit =
      bit::read_bit(bit_file, bit::DirectionRule::hybrid, bit::InsideRule::down).bit;
  bit::export_bit(folder, bit, {.parts = format});
  bit::export_solids(folder, bit, {.solids = "stl"});
}

/// What is left in parts/ once the folder is prepared for another bit.
std::set<std::string> left_of(const std::string& bit_file, const std::string& format) {
  const fs::path folder = test_folder();
  export_to(folder, bit_file, format);
  EXPECT_EQ(exported_parts(folder).size(), files_in(folder / "parts").size());
  write_file(folder / "parts" / ("mine." + format), "mine");
  fs::create_directories(folder / "parts" / "cutter-1");
  write_file(folder / "parts" / "cutter-1" / "notes.txt", "mine");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  return files_in(folder / "parts");
}

using Names = std::set<std::string>;

TEST(OldParts, of_a_pdc_bit_go_and_nothing_else) {
  for (const std::string format : {"ply", "stl"})
    EXPECT_EQ(left_of(TDBD_SOURCE_DIR "/cases/bits/standard.toml", format),
              (Names{"mine." + format, "cutter-1/notes.txt"}));
}

TEST(OldParts, of_a_roller_cone_bit_go_and_nothing_else) {
  EXPECT_EQ(left_of(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml", "off"),
            (Names{"mine.off", "cutter-1/notes.txt"}));
}

/// In the format in which a user keeps one part of several, it is his.
TEST(OldParts, of_a_roller_cone_bit_are_those_of_whole_formats) {
  const fs::path folder = test_folder();
  export_to(folder, TDBD_SOURCE_DIR "/cases/bits/bit-r.toml", "ply");
  write_file(folder / "parts" / "cone-1" / "body.stl", "mine");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  EXPECT_EQ(files_in(folder / "parts"), Names{"cone-1/body.stl"});
}

TEST(OldParts, leave_no_empty_folders) {
  const fs::path folder = test_folder();
  export_to(folder, TDBD_SOURCE_DIR "/cases/bits/standard.toml", "ply");
  prepare(folder, Overwrite::force, {}, ResultKind::bit);
  EXPECT_FALSE(fs::exists(folder / "parts"));
}

/// A bit.toml that names files elsewhere removes none of them.
TEST(OldParts, are_below_parts_only) {
  const fs::path folder = test_folder();
  const std::string own = write_file(folder / "own.ply", "mine");
  fs::create_directories(folder / "out");
  for (const std::string& file :
       {std::string("../own.ply"), std::string("parts/../../own.ply"), own}) {
    write_file(
        folder / "out" / "bit.toml",
        "# A bit as the meshes of its parts.\nname = \"a\"\n[[parts]]\nname = \"p\"\nfile = \"" +
            file + "\"\n");
    prepare(folder / "out", Overwrite::force, {}, ResultKind::bit);
    EXPECT_TRUE(fs::exists(own)) << file;
  }
}

}  // namespace tdbd::old_parts_test

#include "simulation/result/output_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::output_folder_test {

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

TEST(OutputFolder, whose_frames_are_a_file_is_refused) {
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

TEST(OutputFolder, that_another_command_writes_to_is_refused) {
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

TEST(OutputFolder, that_is_a_file_or_cannot_be_made_is_refused) {
  const fs::path file = nothing_at("file");
  write(file, "x");
  EXPECT_EQ(refusal(file, Overwrite::force), "is a file");
  EXPECT_NE(refusal(file / "below"), "not refused");
  EXPECT_NE(refusal("/proc/tdbd"), "not refused");
}

}  // namespace tdbd::simulation::output_folder_test

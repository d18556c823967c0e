#include "simulation/result/output_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

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

void touch(const fs::path& path) { std::ofstream(path) << "x"; }

std::string refusal(const fs::path& path, Overwrite overwrite = Overwrite::no) {
  try {
    prepare(path, overwrite);
  } catch (const InputError& e) {
    return e.what();
  }
  return "not refused";
}

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

TEST(OutputFolder, with_files_needs_force) {
  const OutputFolder folder = prepare(nothing_at("full"), Overwrite::no);
  touch(folder.summary());
  EXPECT_EQ(refusal(folder.path),
            "output folder " + folder.path.string() + ": exists; --force overwrites");
  EXPECT_TRUE(fs::exists(folder.summary()));
}

TEST(OutputFolder, force_removes_old_results_and_nothing_else) {
  const OutputFolder folder = prepare(nothing_at("force"), Overwrite::no);
  for (const fs::path& old : {folder.summary(), folder.history(), folder.frame("rock", 99)})
    touch(old);
  touch(folder.path / "notes.txt");
  prepare(folder.path, Overwrite::force);
  EXPECT_FALSE(fs::exists(folder.summary()));
  EXPECT_FALSE(fs::exists(folder.frame("rock", 99)));
  EXPECT_TRUE(fs::exists(folder.path / "notes.txt"));
}

TEST(OutputFolder, that_is_a_file_or_cannot_be_made_is_refused) {
  const fs::path file = nothing_at("file");
  touch(file);
  EXPECT_EQ(refusal(file, Overwrite::force), "output folder " + file.string() + ": is a file");
  EXPECT_NE(refusal(file / "below"), "not refused");
  EXPECT_NE(refusal("/proc/tdbd"), "not refused");
}

}  // namespace tdbd::simulation::output_folder_test

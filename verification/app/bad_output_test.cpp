#include <gtest/gtest.h>

#include "app/small_case.hpp"
#include "io/output_folder.hpp"

namespace tdbd::app::bad_output_test {

namespace fs = std::filesystem;

void expect_output_refused(const battery::Outcome& o, const fs::path& folder,
                           const std::string& reason) {
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "tdbd: output folder " + folder.string() + ": " + reason + "\n");
}

TEST(BadOutput, an_existing_result_is_kept_without_force) {
  const SmallCase c;
  ASSERT_EQ(c.run().exit_code, 0);
  const std::string before = read(c.path("out/summary.json"));
  expect_output_refused(c.run({"--set", "time.duration=0.02"}), c.path("out"),
                        "exists; --force overwrites");
  EXPECT_EQ(read(c.path("out/summary.json")), before);
  ASSERT_EQ(c.run({"--set", "time.duration=0.02", "--force"}).exit_code, 0);
  EXPECT_NE(read(c.path("out/summary.json")), before);
}

TEST(BadOutput, a_wrong_case_keeps_the_old_result_even_with_force) {
  const SmallCase c;
  ASSERT_EQ(c.run().exit_code, 0);
  const std::string before = read(c.path("out/summary.json"));
  EXPECT_EQ(c.run({"--force", "--set", "rock.wall=1e9"}).exit_code, 2);
  EXPECT_EQ(read(c.path("out/summary.json")), before);
}

TEST(BadOutput, force_leaves_no_old_frame_and_deletes_nothing_foreign) {
  const SmallCase c;
  const auto first = c.run({"--set", "output.frames_every=1"});
  ASSERT_EQ(first.exit_code, 0);
  EXPECT_NE(first.out.find("to view it: "), std::string::npos) << first.out;
  for (const char* foreign : {"out/notes.txt", "out/frames/mine.vtp", "out/frames/rock.vtp"})
    c.write(foreign, "mine");
  const auto second = c.run({"--force", "--set", "output.frames_every=0"});
  ASSERT_EQ(second.exit_code, 0);
  EXPECT_EQ(second.out.find("to view it: "), std::string::npos) << second.out;
  for (const char* foreign : {"out/notes.txt", "out/frames/mine.vtp", "out/frames/rock.vtp"})
    EXPECT_EQ(read(c.path(foreign)), "mine") << foreign;
  EXPECT_FALSE(fs::exists(c.path("out/frames/rock-000001.vtp")));
}

TEST(BadOutput, a_case_that_a_user_wrote_is_not_replaced) {
  const SmallCase c;
  const std::string own = read(c.path("case.toml"));
  expect_output_refused(
      c.run({"--force"}, "."), c.path("."),
      "holds the input " + c.path("case.toml").string() + "; take another folder");
  EXPECT_EQ(read(c.path("case.toml")), own);
  EXPECT_EQ(files_below(c.path(".")),
            (std::vector<std::string>{"bit.csv", "bit.toml", "case.toml"}));
}

TEST(BadOutput, an_input_is_not_replaced) {
  const SmallCase c;
  ASSERT_EQ(c.run().exit_code, 0);
  const fs::path resolved = c.path("out/case.toml");
  const std::string before = read(resolved);
  const auto o = battery::run_tdbd({"run", resolved, "-o", c.path("out"), "--force"});
  expect_output_refused(o, c.path("out"),
                        "holds the input " + resolved.string() + "; take another folder");
  EXPECT_EQ(read(resolved), before);
}

TEST(BadOutput, two_runs_into_one_folder) {
  const SmallCase c;
  fs::create_directory(c.path("out"));
  {
    const FolderLock other(c.path("out"));
    expect_output_refused(
        c.run(), c.path("out"),
        "in use: another command writes to it; wait until it ends or choose another folder");
    EXPECT_EQ(files_below(c.path("out")), std::vector<std::string>{});
  }
  const auto killed =
      c.run({"--set", "time.duration=1000", "--set", "output.frames_every=1"}, "out",
            {.signal_after = c.path("out/frames/rock-000001.vtp"), .signal = SIGKILL});
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
  EXPECT_EQ(c.run({"--force"}).exit_code, 0);
}

/// NetCDF reads them in its own way: it wrote "/history.nc" for the folder " ".
TEST(BadOutput, names_of_folders_that_are_read_otherwise_elsewhere_are_just_names) {
  const SmallCase c;
  for (const std::string name :
       {" ", "a\\b", "http:", "file:///x", "a#b", "a?mode=bytes", "[x]y"}) {
    const auto o = c.run({"--quiet"}, "names/" + name);
    EXPECT_EQ(o.exit_code, 0) << name << ": " << o.err;
    const std::string history = read(c.path("names/" + name) / "history.nc");
    EXPECT_EQ(history.substr(1, 3), "HDF") << name;
  }
}

TEST(BadOutput, a_file_in_place_of_a_folder) {
  const SmallCase c;
  c.write("out", "mine");
  expect_output_refused(c.run({"--force"}), c.path("out"), "is a file");
  expect_output_refused(c.run({}, "out/below"), c.path("out/below"), "Not a directory");
  EXPECT_EQ(read(c.path("out")), "mine");
  fs::create_directory(c.path("taken"));
  c.write("taken/frames", "mine");
  expect_output_refused(c.run({"--force"}, "taken"), c.path("taken"), "its frames is a file");
}

/// A superuser ignores permissions, but no user can create a folder in /proc.
TEST(BadOutput, a_read_only_folder) {
  const SmallCase c;
  const auto o = battery::run_tdbd({"run", c.path("case.toml"), "-o", "/proc/tdbd"});
  expect_output_refused(o, "/proc/tdbd", "No such file or directory");
}

TEST(BadOutput, a_full_disk_leaves_no_summary) {
  for (const long bytes : {300L, 3000L, 20000L, 60000L}) {
    const SmallCase c;
    const auto o = c.run({}, "out", {.largest_file = bytes});
    EXPECT_EQ(o.exit_code, 1) << bytes;
    EXPECT_NE(o.err.find("cannot write " + c.path("out").string()), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("File too large"), std::string::npos) << o.err;
    EXPECT_EQ(o.out, "");
    EXPECT_FALSE(fs::exists(c.path("out/summary.json")));
    EXPECT_FALSE(fs::exists(c.path("out/timing.json")));
  }
}

TEST(BadOutput, a_full_standard_output) {
  const SmallCase c;
  const auto o = c.run({}, "out", {.standard_output = "/dev/full"});
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_NE(o.err.find("tdbd: cannot write to standard output\n"), std::string::npos) << o.err;
}

}  // namespace tdbd::app::bad_output_test

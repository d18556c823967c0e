#include "app/case_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "verification/core/temporary_folder.hpp"

namespace tdbd::app {

namespace fs = std::filesystem;

CaseFolder::CaseFolder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(tdbd::temporary_folder()) /
            (std::string("tdbd_") + info->test_suite_name() + "_" + info->name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void CaseFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

void CaseFolder::edit(const std::string& name, const std::string& from,
                      const std::string& to) const {
  std::string text = read(path(name));
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from << " is not in " << name;
  write(name, text.replace(place, from.size(), to));
}

battery::Outcome CaseFolder::check(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments{"check", path("case.toml")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return battery::run_tdbd(arguments);
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string read_unstamped(const fs::path& file) {
  std::string text = read(file);
  for (std::size_t at = 0; (at = text.find("\ncomment ", at)) < text.find("\nend_header\n");)
    text.erase(at, text.find('\n', at + 1) - at);
  return text;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

void expect_same_results(const fs::path& a, const fs::path& b, std::size_t least) {
  const std::vector<std::string> files = files_below(a);
  ASSERT_EQ(files, files_below(b));
  ASSERT_GE(files.size(), least);
  for (const std::string& file : files)
    EXPECT_TRUE(file == "timing.json" || read(a / file) == read(b / file)) << file;
}

long lines_of(const fs::path& file) {
  const std::string text = read(file);
  return static_cast<long>(std::count(text.begin(), text.end(), '\n'));
}

bool history_opens(const fs::path& file, long rows) {
  const std::string command =
      "/usr/bin/python3 -c 'import sys, xarray; h = xarray.open_dataset(sys.argv[1], "
      "decode_times=False); assert h.sizes[\"time\"] == int(sys.argv[2])' " +
      file.string() + " " + std::to_string(rows);
  return std::system(command.c_str()) == 0;
}

void expect_refusal(const battery::Outcome& o, const std::string& message) {
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "tdbd: " + message + "\n");
  EXPECT_EQ(o.out, "");
}

}  // namespace tdbd::app

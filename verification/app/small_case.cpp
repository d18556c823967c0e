#include "app/small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace tdbd::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* case_text = R"([bit]
file = "bit.toml"
[rock]
edge_length = "4 mm"
wall = "20 mm"
[motion]
rotary_speed = "120 rpm"
rate_of_penetration = "30 m/h"
[time]
step = "2 ms"
duration = "40 ms"
)";

constexpr const char* bit_text = R"(name = "small"
table = "bit.csv"
gage_diameter = "100 mm"
[mesh]
rim_segments = 24
)";

constexpr const char* table_text =
    R"(bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg
S,1,1,cone,16,5,0,6,-15,15,0
S,2,2,cone,16,15,180,3.3,-15,15,0
S,3,1,nose,16,25,10,1,0,15,0
S,4,2,nose,16,34,190,1.5,15,15,0
S,5,1,shoulder,16,42,20,5,45,15,0
S,6,2,shoulder,16,47,200,11,70,15,0
)";

}  // namespace

SmallCase::SmallCase() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(::testing::TempDir()) /
            (std::string("tdbd_") + info->test_suite_name() + "_" + info->name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  write("case.toml", case_text);
  write("bit.toml", bit_text);
  write("bit.csv", table_text);
}

void SmallCase::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

void SmallCase::edit(const std::string& name, const std::string& from,
                     const std::string& to) const {
  std::string text = read(path(name));
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from << " is not in " << name;
  write(name, text.replace(place, from.size(), to));
}

battery::Outcome SmallCase::run(std::vector<std::string> more, const std::string& out,
                                const battery::Surroundings& around) const {
  more.insert(more.begin(), {"run", path("case.toml"), "-o", path(out)});
  return battery::run_tdbd(more, around);
}

battery::Outcome SmallCase::check(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments{"check", path("case.toml")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return battery::run_tdbd(arguments);
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

void expect_refused(const SmallCase& c, const std::string& message) {
  const std::string expected = "tdbd: " + c.path(message).string() + "\n";
  for (const battery::Outcome& o : {c.check(), c.run()}) {
    EXPECT_EQ(o.exit_code, 2);
    EXPECT_EQ(o.err, expected);
    EXPECT_EQ(o.out, "");
  }
  EXPECT_FALSE(fs::exists(c.path("out")));
}

}  // namespace tdbd::app

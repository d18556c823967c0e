#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <regex>

#include "app/small_case.hpp"

/// The line with the estimated memory, time and disk space of a run.
namespace tdbd::app::check_command_test {

/// "about 1.3e+03 triangles at the end, 2.1 MB of memory, 0.92 MB on disk, 1.2 min here (90 steps
/// were tried)", in numbers.
struct Told {
  double triangles = 0.0, memory = 0.0, disk = 0.0, time = 0.0;
  std::string memory_unit, disk_unit, time_unit;
  long tried = 0;

  double bytes_on_disk() const { return disk * (disk_unit == "GB" ? 1e9 : 1e6); }
  double seconds() const {
    return time * (time_unit == "h" ? 3600.0 : time_unit == "min" ? 60.0 : 1.0);
  }
};

Told told_of(const SmallCase& c, const std::vector<std::string>& settings) {
  std::vector<std::string> words;
  for (const std::string& s : settings) words.insert(words.end(), {"--set", s});
  const auto o = c.check(words);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  Told t;
  char memory[8] = "", disk[8] = "", time[8] = "";
  const auto at = o.out.find("about ");
  if (at == std::string::npos) return t;
  const int read =
      std::sscanf(o.out.c_str() + at,
                  "about %lg triangles at the end, %lg %7s of memory, %lg %7s on "
                  "disk, %lg %7s on this machine (from %ld trial steps)",
                  &t.triangles, &t.memory, memory, &t.disk, disk, &t.time, time, &t.tried);
  EXPECT_EQ(read, 8) << o.out;
  t.memory_unit = memory;
  t.disk_unit = disk;
  t.time_unit = time;
  return t;
}

std::string lasting(double seconds) { return "time.duration=" + std::to_string(seconds); }

/// A triangle takes 250 bytes, and the index of a coarse rock less than they do.
TEST(CheckEstimate, reports_memory_of_its_triangles) {
  const Told t = told_of(SmallCase(), {});
  EXPECT_EQ(t.memory_unit, "MB");
  EXPECT_GT(1e6 * t.memory, 240.0 * t.triangles);  // two digits of each
  EXPECT_LT(1e6 * t.memory, 700.0 * t.triangles);
  EXPECT_GT(t.tried, 0);
}

/// 1300, not 1.3e+03.
TEST(CheckEstimate, has_no_exponents) {
  const std::regex two_digits(R"(about [1-9]\d0* triangles at the end, .*\n)");
  for (const std::string edge : {"4 mm", "8 mm", "16 mm"}) {
    const auto o = SmallCase().check({"--set", "rock.edge_length=" + edge});
    ASSERT_EQ(o.exit_code, 0) << o.err;
    const std::string line = o.out.substr(std::min(o.out.find("about "), o.out.size()));
    EXPECT_TRUE(std::regex_match(line, two_digits)) << line;
    EXPECT_FALSE(std::regex_search(line, std::regex(R"(\de[+-]\d)"))) << line;
  }
}

/// A thousand times the frames take a thousand times the room, in the next unit.
TEST(CheckEstimate, reports_disk_space_in_a_suitable_unit) {
  const SmallCase c;
  const std::vector<std::string> flat{"output.frames_every=1", "output.history_every=1000",
                                      "motion.rate_of_penetration=1e-9"};
  const auto with = [&](double seconds) {
    std::vector<std::string> settings = flat;
    settings.push_back(lasting(seconds));
    return told_of(c, settings);
  };
  const Told few = with(2.0), many = with(2000.0);
  EXPECT_EQ(few.disk_unit, "MB");
  EXPECT_EQ(many.disk_unit, "GB");
  EXPECT_NEAR(many.bytes_on_disk() / few.bytes_on_disk(), 1000.0, 30.0);
}

/// However fast the machine is just now: seconds up to two minutes, minutes up to two hours.
TEST(CheckEstimate, reports_time_in_a_suitable_unit) {
  const SmallCase c;
  const std::string slow = "motion.rate_of_penetration=1e-9";
  const double of_a_second = told_of(c, {slow, lasting(10.0)}).seconds() / 10.0;
  ASSERT_GT(of_a_second, 0.0);
  const std::map<std::string, std::pair<double, double>> range{
      {"s", {0.0, 120.0}}, {"min", {2.0, 120.0}}, {"h", {2.0, 1e9}}};
  for (const double wanted : {20.0, 130.0, 145.0, 1000.0, 6500.0, 7500.0, 8500.0, 9800.0, 3e4}) {
    const Told t = told_of(c, {slow, lasting(wanted / of_a_second)});
    ASSERT_TRUE(range.contains(t.time_unit)) << t.time_unit;
    EXPECT_GE(t.time, range.at(t.time_unit).first) << t.time_unit;
    EXPECT_LE(t.time, range.at(t.time_unit).second) << t.time_unit;
  }
}

}  // namespace tdbd::app::check_command_test

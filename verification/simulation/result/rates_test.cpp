#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "simulation/result/run.hpp"
#include "verification/simulation/result_files.hpp"

/// Rates of a bit that forces move are displacements over time.
namespace tdbd::simulation::rates_test {

constexpr double rounding = 1e-12;  ///< relative

/// A shipped case on coarse rock, and the same to the start of its means alone.
constexpr double duration = 0.03, means_from = 0.012;  ///< s
Case with(const std::string& name, double until) {
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml",
                   {"rock.edge_length='6 mm'", fmt::format("time.duration={}", until),
                    fmt::format("output.means_from={}", means_from), "output.history_every=1"});
}

/// The columns of history.csv by their names.
using Columns = std::map<std::string, std::vector<double>>;
Columns columns_of(const std::filesystem::path& folder) {
  std::istringstream in(result_files(folder).at("history.csv"));
  std::vector<std::string> names;
  std::string line, word;
  std::getline(in, line);
  for (std::istringstream head(line); std::getline(head, word, ',');)
    names.push_back(word.substr(0, word.find(' ')));
  Columns columns;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (const std::string& name : names) {
      std::getline(cells, word, ',');
      columns[name].push_back(std::stod(word));
    }
  }
  return columns;
}

/// The row at which the means begin.
std::size_t first_row(const std::vector<double>& times, double from) {
  const auto near =
      std::ranges::min_element(times, {}, [from](double t) { return std::abs(t - from); });
  return static_cast<std::size_t>(near - times.begin());
}

class Rates : public testing::TestWithParam<const char*> {};

/// Means of the summary, and every row of the history: the bit's way less that of the rock, and its
/// turn about the axis.
TEST_P(Rates, are_displacements_over_time) {
  const Case c = with(GetParam(), duration);
  const auto folder = test_folder() / "out";
  run(c, {.folder = folder});
  const auto summary = nlohmann::json::parse(result_files(folder).at("summary.json"));
  Columns h = columns_of(folder);
  const std::vector<double>&t = h["time"], &turned = h["rotation_angle"];
  std::vector<double> z = h["position_z"];
  for (std::size_t i = 0; i < z.size(); ++i) z[i] -= h["rock_position_z"][i];
  const std::size_t first = first_row(t, summary.at("means_from_s"));
  const double time = t.back() - t[first];
  const double advance = (z.back() - z[first]) / time,
               turn = (turned.back() - turned[first]) / time;
  const double way = *std::ranges::max_element(z) - *std::ranges::min_element(z);
  EXPECT_NEAR(summary.at("rop_mean_m_per_s"), advance, rounding * way / time);
  EXPECT_NEAR(summary.at("rotary_speed_mean_rad_per_s"), turn, rounding * turn);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double dt = c.time.step;
    const double far = std::abs(z[i]) + way;  // its rounding over a step
    EXPECT_NEAR(h["rate_of_penetration"][i], (z[i] - z[i - 1]) / dt, 1e-15 * far / dt) << i;
    EXPECT_NEAR(h["rotary_speed"][i], (turned[i] - turned[i - 1]) / dt, 1e-15 * turned[i] / dt);
  }
}

INSTANTIATE_TEST_SUITE_P(OfDynamicCases, Rates,
                         testing::Values("drill-bit-b", "drill-bit-b-whirl",
                                         "drill-bit-b-whirl-rock", "drill-bit-m", "drill-bit-r",
                                         "stick-slip", "bit-bounce", "high-frequency",
                                         "high-frequency-beds", "laboratory"));

/// Turn of the cone over that of the bit; rolling is positive.
TEST(ConeRates, are_turns_over_turns) {
  const Case c = with("drill-bit-r", duration);
  const auto folder = test_folder() / "out";
  run(c, {.folder = folder});
  const auto summary = nlohmann::json::parse(result_files(folder).at("summary.json"));
  Simulation s = start(c);
  const std::vector<double> from = angles_of(s.state.cones);
  const double turned = s.state.place.turned;
  while (s.state.steps_done < c.time.steps) step(c, s);
  ASSERT_EQ(summary.at("cones").size(), 3U);
  for (std::size_t k = 0; k < from.size(); ++k) {
    const double ratio = -(s.state.cones[k].angle - from[k]) / (s.state.place.turned - turned);
    EXPECT_NEAR(summary.at("cones")[k].at("mean_speed_ratio"), ratio, rounding * ratio);
  }
}

}  // namespace tdbd::simulation::rates_test

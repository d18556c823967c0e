#include <gtest/gtest.h>
#include <netcdf.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "simulation/result/history.hpp"
#include "verification/battery/generators.hpp"
#include "verification/core/temporary_folder.hpp"

/// Rows that stand for many steps: what they have of them.
namespace tdbd::simulation::history_window_test {

namespace fs = std::filesystem;

constexpr long steps = 23, every = 5;

/// What a bit of one part and one cutter does in a step.
struct Step {
  std::vector<double> removed = {0.0};
  std::array<rock::Section, 1> sections;
  BitLoads loads;
  HistoryRow row;
};

Step random_step(long k) {
  Step s;
  s.removed[0] = *battery::number(0.0, 1.0);
  s.sections[0].area = *battery::number(0.0, 2.0);
  s.sections[0].centroid_B = *battery::point(1.0);
  s.loads.force_W = *battery::point(100.0);
  s.loads.parts.resize(1);
  s.loads.parts[0].normal = *battery::number(0.0, 50.0);
  s.row.time = 0.001 * static_cast<double>(k + 1);
  s.row.swept_vertices = *battery::integer(0, 1000);
  s.row.rock_triangles = 1000 + k;
  return s;
}

void take(const Step& s, History& history) {
  HistoryRow row = s.row;
  row.removed_volume_by_part = s.removed;
  row.sections = s.sections;
  const BitVelocity velocity;
  const Pose X_WB;
  const LoadedStep loaded{s.loads, velocity, X_WB, s.removed, 0.001, {}};
  row.loaded = &loaded;
  history.take(row);
}

/// A variable of a file, all of its numbers.
std::vector<double> numbers(const fs::path& file, const std::string& name, std::size_t count) {
  int nc = -1, variable = -1;
  std::vector<double> found(count);
  RC_ASSERT(nc_open(file.c_str(), NC_NOWRITE, &nc) == NC_NOERR);
  RC_ASSERT(nc_inq_varid(nc, name.c_str(), &variable) == NC_NOERR);
  RC_ASSERT(nc_get_var_double(nc, variable, found.data()) == NC_NOERR);
  nc_close(nc);
  return found;
}

HistoryExtent extent() {
  HistoryExtent e;
  e.cutters = {"cutter-1"};
  e.forces = true;
  return e;
}

fs::path file_in(const std::string& name) {
  const fs::path folder = temporary_folder() + "tdbd_window_" + name;
  fs::create_directories(folder);
  return folder / "history.nc";
}

/// Writes rows of `every` steps; the history is closed and opened again at `stop`, as a run that was
/// killed there would.
fs::path write(const std::vector<Step>& all, long stop, const std::string& name) {
  const fs::path file = file_in(name);
  std::vector<std::vector<double>> rows;
  HistoryWindow window;
  for (const auto& [from, to] : {std::pair{0L, stop}, {stop, steps}}) {
    History history(file, {{"cutter-1/face", "face"}}, extent(), Rows::of_windows);
    for (const std::vector<double>& row : rows) history.append_again(row);
    history.set_window(window);
    for (long k = from; k < to; ++k) {
      take(all[at(static_cast<int>(k))], history);
      const bool is_row = (k + 1) % every == 0 || k + 1 == steps;
      if (is_row && history.write()) rows.push_back(history.last_row());
    }
    window = history.window();
    history.close();
  }
  return file;
}

/// The steps of each row.
std::vector<std::pair<long, long>> windows() {
  std::vector<std::pair<long, long>> found;
  for (long from = 0; from < steps; from += every)
    found.emplace_back(from, std::min(from + every, steps));
  return found;
}

RC_GTEST_PROP(HistoryWindow, has_means_sums_extremes_and_last_values, ()) {
  std::vector<Step> all;
  for (long k = 0; k < steps; ++k) all.push_back(random_step(k));
  const fs::path file = write(all, *battery::integer(0, steps), "values");
  const auto rows = windows();
  const auto of = [&](const char* name) { return numbers(file, name, rows.size()); };
  const auto time = of("time"), swept = of("swept_vertices"), triangles = of("rock_triangles"),
             weight = of("weight_on_bit"), least = of("weight_on_bit_min"),
             greatest = of("weight_on_bit_max"), area = of("section_area_total"),
             removed = of("removed_volume_by_part"), normal = of("force_normal"),
             centroid = of("section_centroid_x");
  for (std::size_t r = 0; r < rows.size(); ++r) {
    double sum_weight = 0.0, sum_area = 0.0, sum_removed = 0.0, sum_swept = 0.0, sum_normal = 0.0;
    double lo = INFINITY, hi = -INFINITY;
    for (long k = rows[r].first; k < rows[r].second; ++k) {
      const Step& s = all[at(static_cast<int>(k))];
      const double w = -s.loads.force_W.z();
      sum_weight += w;
      lo = std::min(lo, w);
      hi = std::max(hi, w);
      sum_area += s.sections[0].area;
      sum_removed += s.removed[0];
      sum_swept += static_cast<double>(s.row.swept_vertices);
      sum_normal += s.loads.parts[0].normal;
    }
    const auto count = static_cast<double>(rows[r].second - rows[r].first);
    const Step& last = all[at(static_cast<int>(rows[r].second - 1))];
    constexpr double single = 1e-7;  // relative: of numbers by part and cutter
    RC_ASSERT(weight[r] == sum_weight / count);
    RC_ASSERT(least[r] == lo);
    RC_ASSERT(greatest[r] == hi);
    RC_ASSERT(area[r] == sum_area / count);
    RC_ASSERT(swept[r] == sum_swept);
    RC_ASSERT(time[r] == last.row.time);
    RC_ASSERT(triangles[r] == static_cast<double>(last.row.rock_triangles));
    RC_ASSERT(std::abs(removed[r] - sum_removed) <= single * sum_removed);
    RC_ASSERT(std::abs(normal[r] - sum_normal / count) <= single * sum_normal / count);
    RC_ASSERT(std::abs(centroid[r] - last.sections[0].centroid_B.x()) <=
              single * std::abs(centroid[r]));
  }
}

TEST(HistoryWindow, of_what_is_not_known_has_no_mean_but_extremes) {
  History history(file_in("unknown"), {{"cutter-1/face", "face"}}, extent(), Rows::of_windows);
  Step known, unknown;
  for (Step* s : {&known, &unknown}) s->loads.parts.resize(1);
  known.sections[0].area = 2.0;
  unknown.sections[0].area = std::nan("");
  for (const Step* s : {&unknown, &known, &unknown}) take(*s, history);
  ASSERT_TRUE(history.write());
  history.close();
  const auto row = [&](const char* name) { return numbers(file_in("unknown"), name, 1).front(); };
  EXPECT_TRUE(std::isnan(row("section_area_total")));
  EXPECT_EQ(row("section_area_total_min"), 2.0);
  EXPECT_EQ(row("section_area_total_max"), 2.0);
}

TEST(HistoryWindow, without_a_step_is_no_row) {
  History history(file_in("none"), {{"cutter-1/face", "face"}}, extent(), Rows::of_windows);
  EXPECT_FALSE(history.write());
  Step s;
  s.loads.parts.resize(1);
  take(s, history);
  EXPECT_TRUE(history.write());
  EXPECT_FALSE(history.write());
}

}  // namespace tdbd::simulation::history_window_test

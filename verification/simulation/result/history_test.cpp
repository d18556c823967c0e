#include "simulation/result/history.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/out_of_memory.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::history_test {

namespace fs = std::filesystem;

const std::vector<HistoryPart> parts = {{"cutter-1/face", "face"}, {"gage-pad-1", "gage_pad"}};

/// An empty folder of one test.
fs::path folder(const std::string& name) {
  const fs::path path = tdbd::temporary_folder() + "tdbd_history_" + name;
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Numbers with all digits in use, that check_history.py computes too.
void append_rows(History& history, long first, long last) {
  for (long i = first; i < last; ++i) {
    const double t = 0.001 * static_cast<double>(i);
    const double by_part[] = {t / 3.0, t / 7.0};
    HistoryRow row;
    row.time = t;
    row.p_WB = Vec3(t / 11.0, t / 13.0, t / 17.0);
    row.rotation_vector = Vec3(t / 19.0, t / 23.0, t / 29.0);
    row.rotation_angle = t / 31.0;
    row.removed_volume_total = t / 37.0;
    row.removed_volume_by_part = by_part;
    row.swept_vertices = 2 * i;
    row.rock_triangles = 1000 + i;
    history.append(row);
  }
}

fs::path write_history(const fs::path& where, long rows) {
  History history(where / "history.nc", parts);
  append_rows(history, 0, rows);
  history.close();
  return where / "history.nc";
}

int check_by_xarray(const fs::path& file, long rows) {
  const std::string command = std::string("/usr/bin/python3 ") + TDBD_SOURCE_DIR +
                              "/verification/simulation/result/check_history.py " + file.string() +
                              " " + std::to_string(rows);
  return std::system(command.c_str());
}

TEST(History, xarray_finds_every_bit_with_units_and_names) {
  for (const long rows : {0L, 1L, 511L, 512L, 1300L})
    EXPECT_EQ(check_by_xarray(write_history(folder("bits"), rows), rows), 0) << rows << " rows";
}

constexpr std::array<const char*, 2> cutters{"cutter-3", "cutter-7"};

/// One row with contact areas and sections, the second one not known.
fs::path write_measures(const fs::path& where) {
  HistoryExtent extent;
  extent.cutters.assign(cutters.begin(), cutters.end());
  extent.contact_areas = true;
  History history(where / "history.nc", parts, extent);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::array<rock::Section, 2> sections{
      rock::Section{1e-6, Vec3(0.1, 0.2, 0.3), 4e-3, 0.5, 6e-7, rock::OutlineStatus::clear,
                    Vec3(0.7, 0.8, 0.9)},
      rock::Section{unknown, Vec3::Constant(unknown), unknown, unknown, unknown,
                    rock::OutlineStatus::over_the_top, Vec3::Constant(unknown)}};
  const std::array<double, 2> volumes{1e-9, 2e-9};
  const std::array<rock::PartContact, 2> contacts{rock::PartContact{{3e-6}, {}, 0.0},
                                                  rock::PartContact{{4e-6}, {}, 0.0}};
  HistoryRow row;
  row.removed_volume_by_part = volumes;
  row.contacts = contacts;
  row.sections = sections;
  history.append(row);
  history.close();
  return where / "history.nc";
}

TEST(History, xarray_finds_sections_by_cutter_and_contact_areas_by_part) {
  const fs::path file = write_measures(folder("measures"));
  EXPECT_EQ(check_by_xarray(file, -1), 0);
  std::ifstream in(fs::path(file).replace_extension(".csv"));
  std::string head;
  std::getline(in, head);
  EXPECT_NE(head.find("contact_area_total [m2],section_area_total [m2]"), std::string::npos);
}

TEST(History, two_runs_are_bitwise_identical) {
  const fs::path a = write_history(folder("a"), 700);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a time stamp would differ
  const fs::path b = write_history(folder("b"), 700);
  EXPECT_EQ(bytes_of(a), bytes_of(b));
  EXPECT_EQ(bytes_of(a.parent_path() / "history.csv"), bytes_of(b.parent_path() / "history.csv"));
}

TEST(History, the_files_get_their_names_when_closed) {
  const fs::path where = folder("names");
  {
    History history(where / "history.nc", parts);
    append_rows(history, 0, 600);
    EXPECT_FALSE(fs::exists(where / "history.nc"));
  }
  EXPECT_TRUE(fs::exists(where / "history.nc.partial"));
  EXPECT_EQ(check_by_xarray(where / "history.nc.partial", 512), 0);
  write_history(where, 3);
  EXPECT_TRUE(fs::exists(where / "history.nc"));
  EXPECT_FALSE(fs::exists(where / "history.nc.partial"));
  EXPECT_FALSE(fs::exists(where / "history.csv.partial"));
}

TEST(History, the_csv_has_a_head_with_units_and_a_line_for_each_row) {
  std::ifstream in(write_history(folder("csv"), 3).replace_extension(".csv"));
  std::string head, first, second;
  std::getline(in, head);
  std::getline(in, first);
  std::getline(in, second);
  EXPECT_EQ(head.substr(0, 25), "time [s],position_x [m],p");
  EXPECT_EQ(second.substr(0, 6), "0.001,");
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(first.begin(), first.end(), ','));
}

TEST(History, a_row_for_other_parts_is_rejected) {
  History history(folder("refused") / "history.nc", parts);
  EXPECT_THROW(history.append(HistoryRow{}), RunError);
}

TEST(History, a_row_with_missing_values_is_rejected) {
  for (const bool drives : {true, false}) {
    HistoryExtent extent;
    (drives ? extent.drive : extent.forces) = true;
    History history(folder("lacking") / "history.nc", parts, extent);
    const double by_part[] = {0.0, 0.0};
    HistoryRow row;
    row.removed_volume_by_part = by_part;
    EXPECT_THROW(history.append(row), RunError) << drives;
  }
}

TEST(History, a_folder_that_does_not_exist_is_an_error) {
  EXPECT_THROW(History("/proc/no/history.nc", parts), RunError);
}

TEST(History, a_row_of_a_hundred_parts_takes_less_than_a_tenth_of_a_millisecond) {
  const std::vector<HistoryPart> many(100, {"cutter/face", "face"});
  const std::vector<double> volumes(100, 1.0 / 3.0);
  History history(folder("cost") / "history.nc", many);
  HistoryRow row;
  row.removed_volume_by_part = volumes;
  const std::clock_t start = std::clock();  // the processor's time: other programs cost none of it
  for (int i = 0; i < 2048; ++i) history.append(row);
  const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(spent / 2048, 1e-4);  // wide: what is required; a slower processor takes longer
}

/// NetCDF and HDF5 would crash in the middle of their work: it is not even begun.
TEST(MemoryLeftForHistories, is_demanded_before_each_call) {
  const auto begun = [] {
    auto h = std::make_unique<History>(folder("memory") / "history.nc", parts);
    append_rows(*h, 0, 511);
    return h;
  };
  EXPECT_TRUE(
      battery::throws_for_want_of_memory([] { return fs::path("/no/history.nc"); },
                                         [](const fs::path& path) { History(path, parts); }));
  EXPECT_TRUE(battery::throws_for_want_of_memory(
      begun, [](std::unique_ptr<History>& h) { append_rows(*h, 511, 512); }));
  EXPECT_TRUE(
      battery::throws_for_want_of_memory(begun, [](std::unique_ptr<History>& h) { h->close(); }));
}

}  // namespace tdbd::simulation::history_test

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

TEST(HistoryWindow, of_undefined_values_has_extremes_but_no_mean) {
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

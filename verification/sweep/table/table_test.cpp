#include "sweep/table/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netcdf.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <optional>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/whole_file.hpp"
#include "reference/sweep/not_dominated.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/out_of_memory.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::front_test {

/// Few values, so that rows are often equal in one goal or in all.
RC_GTEST_PROP(Front, agrees_with_the_slow_twin, ()) {
  const int goals = *battery::integer(1, 3), count = *battery::integer(0, 40);
  std::vector<Goal> senses;
  std::vector<char> larger;
  for (int k = 0; k < goals; ++k) {
    larger.push_back(static_cast<char>(*battery::integer(0, 1)));
    senses.push_back(
        {"g" + std::to_string(k), larger.back() != 0 ? Sense::larger : Sense::smaller});
  }
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < count; ++i) {
    auto& row = rows.emplace_back();
    for (int k = 0; k < goals; ++k) row.push_back(*battery::integer(0, 5));
    if (*battery::integer(0, 9) == 0) row[0] = std::numeric_limits<double>::quiet_NaN();
  }
  RC_ASSERT(front_of(rows, senses) == reference::not_dominated(rows, larger));
}

TEST(Front, keeps_equal_rows_and_needs_a_goal) {
  EXPECT_EQ(front_of({{1.0, 2.0}, {1.0, 2.0}, {2.0, 2.0}}, {{"a"}, {"b"}}),
            (std::vector<char>{1, 1, 0}));
  EXPECT_EQ(front_of({{}, {}}, {}), (std::vector<char>{0, 0}));
}

}  // namespace tdbd::sweep::front_test

namespace tdbd::sweep::table_netcdf_test {

namespace fs = std::filesystem;

void require(int status) {
  if (status != NC_NOERR) throw RunError(nc_strerror(status));
}

std::string name_of_attribute(int nc, int variable, int k) {
  char name[NC_MAX_NAME + 1] = "";
  require(nc_inq_attname(nc, variable, k, name));
  return name;
}

std::string value_of_attribute(int nc, int variable, const std::string& name) {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  require(nc_inq_att(nc, variable, name.c_str(), &type, &length));
  if (type == NC_CHAR) {
    std::string text(length, ' ');
    require(nc_get_att_text(nc, variable, name.c_str(), text.data()));
    return text;
  }
  std::vector<signed char> flags(length);
  require(nc_get_att_schar(nc, variable, name.c_str(), flags.data()));
  std::string text;
  for (const signed char f : flags) text += fmt::format("{}b ", static_cast<int>(f));
  return text;
}

std::string attributes(int nc, int variable, int count) {
  std::string text;
  for (int k = 0; k < count; ++k) {
    const std::string name = name_of_attribute(nc, variable, k);
    text += fmt::format("  {}: {}\n", name, value_of_attribute(nc, variable, name));
  }
  return text;
}

std::string value_at(int nc, int variable, nc_type type, std::size_t i) {
  if (type == NC_STRING) {
    char* read = nullptr;
    require(nc_get_var1_string(nc, variable, &i, &read));
    const std::string text = read;
    require(nc_free_string(1, &read));
    return '"' + text + '"';
  }
  double number = 0.0;
  require(nc_get_var1_double(nc, variable, &i, &number));
  return fmt::format("{}", number);
}

std::string variable_text(int nc, int variable, std::size_t points) {
  char name[NC_MAX_NAME + 1] = "";
  nc_type type = NC_NAT;
  int dimensions = 0, count = 0;
  require(nc_inq_var(nc, variable, name, &type, &dimensions, nullptr, &count));
  const char* type_name = type == NC_STRING ? "string" : type == NC_BYTE ? "byte" : "double";
  std::string text = fmt::format("{} {}({})\n", type_name, name, dimensions);
  text += attributes(nc, variable, count) + " ";
  for (std::size_t i = 0; i < points; ++i) text += ' ' + value_at(nc, variable, type, i);
  return text + '\n';
}

/// All that there is, as text.
std::string dump_of(const fs::path& file) {
  int nc = -1, dimensions = 0, variables = 0, count = 0;
  require(nc_open(file.c_str(), NC_NOWRITE, &nc));
  require(nc_inq(nc, &dimensions, &variables, &count, nullptr));
  char name[NC_MAX_NAME + 1] = "";
  std::size_t points = 0;
  require(nc_inq_dim(nc, 0, name, &points));
  std::string text = fmt::format("{} of {}, {} of them\n", name, points, dimensions);
  text += attributes(nc, NC_GLOBAL, count);
  for (int v = 0; v < variables; ++v) text += variable_text(nc, v, points);
  require(nc_close(nc));
  return text;
}

Design two_by_two() {
  Design d;
  d.title = "Two by two";
  d.figures = {"cost", "gain"};
  d.factors = {{"size", {{{"1 mm", ""}, 1.0, "mm"}, {{"2 mm", ""}, 2.0, "mm"}}, {}},
               {"kind", {{{"a, b", ""}, {}, ""}, {{"7", ""}, 7.0, ""}}, {}},
               {"share", {{{"0.5", ""}, 0.5, ""}}, {}}};
  return d;
}

PointRecord record_with(double cost, double gain) {
  return {{PointStatus::done, "h", "", {cost, gain}, false}, 0.5};
}

PointRecord failed() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {{PointStatus::failed, "", "never", {none, none}, false}, 0.5};
}

std::string written(const std::string& name, const Design& d, const PointRecords& records,
                    const Judged& judged = {}) {
  const fs::path file = empty_folder(name) / "t.nc";
  write_netcdf(file, table_of(d, points_of(d), {"0", "1", "2", "3"}, records, judged));
  return dump_of(file);
}

std::string head(const std::string& goals) {
  const Provenance& p = provenance();
  return fmt::format(
      "point of 4, 1 of them\n  title: Two by two\n  command: run\n  source: tdbd {} {}\n{}",
      p.version, p.commit, goals);
}

constexpr const char* factors =
    "double size(1)\n  units: mm\n  long_name: factor size\n  1 1 2 2\n"
    "string kind(1)\n  long_name: factor kind\n  \"a, b\" \"7\" \"a, b\" \"7\"\n"
    "double share(1)\n  units: 1\n  long_name: factor share\n  0.5 0.5 0.5 0.5\n";

constexpr const char* status_head =
    "byte status(1)\n  long_name: how the point ended\n  flag_values: 0b 1b 2b 3b \n"
    "  flag_meanings: done failed missing left_out\n";

TEST(TableNetcdf, holds_factors_figures_and_how_points_ended) {
  const PointRecords records{{"0", record_with(1.0, 3.0)}, {"2", failed()}};
  EXPECT_EQ(written("plain", two_by_two(), records),
            head("") + factors +
                "double cost(1)\n  long_name: figure cost\n  1 nan nan nan\n"
                "double gain(1)\n  long_name: figure gain\n  3 nan nan nan\n" +
                status_head + "  0 2 1 2\n" +
                "string case_hash(1)\n  long_name: of the resolved case\n  \"h\" \"\" \"\" \"\"\n"
                "string message(1)\n  long_name: why the point failed\n  \"\" \"\" \"never\" "
                "\"\"\n");
}

TEST(TableNetcdf, of_goals_and_a_filter_has_a_front_and_what_was_left_out) {
  Design d = two_by_two();
  d.goals = {{"cost", Sense::smaller}, {"gain", Sense::larger}};
  d.filter = Filter{{"imbalance", Sense::smaller}, 3, 0};
  const PointRecords records{
      {"0", record_with(1.0, 3.0)}, {"1", record_with(2.0, 2.0)}, {"3", record_with(9.0, 9.0)}};
  EXPECT_EQ(written("goals", d, records, judged_by(*d.filter, {0.5, 0.25, 0.125, 4.0})),
            head("  goals: cost smaller, gain larger\n") + factors +
                "double planar.imbalance(1)\n  long_name: filter planar.imbalance\n"
                "  0.5 0.25 0.125 4\n"
                "double cost(1)\n  long_name: figure cost\n  1 2 nan nan\n"
                "double gain(1)\n  long_name: figure gain\n  3 2 nan nan\n" +
                status_head + "  0 0 2 3\n" +
                "byte front(1)\n  long_name: whether no other point is as good in every goal and "
                "better in one\n  flag_values: 0b 1b \n  flag_meanings: dominated not_dominated\n"
                "  1 0 0 0\n"
                "string case_hash(1)\n  long_name: of the resolved case\n  \"h\" \"h\" \"\" \"\"\n"
                "string message(1)\n  long_name: why the point failed\n  \"\" \"\" \"\" \"\"\n");
}

TEST(TableNetcdf, that_cannot_be_written_leaves_what_was_there) {
  const fs::path folder = empty_folder("no_file");
  fs::create_directories(folder / "t.nc.partial");  // where the new file would begin
  std::ofstream(folder / "t.nc") << "old";
  const Design d = two_by_two();
  EXPECT_THROW(write_netcdf(folder / "t.nc", table_of(d, points_of(d), {"0", "1", "2", "3"}, {})),
               RunError);
  EXPECT_EQ(fs::file_size(folder / "t.nc"), 3u);
}

/// A table of so many points, none of which is done.
Table empty_table(const Design& d, std::size_t points) {
  Table t;
  t.design = &d;
  t.points.assign(points, nullptr);
  return t;
}

/// Memory goes with the points. What is there is left alone where it would not do: no file is begun.
TEST(TableNetcdfMemoryLeft, is_demanded_for_every_point_before_a_file_is_begun) {
  const fs::path folder = empty_folder("memory");
  const Design d = two_by_two();
  const auto refuses = [&](std::size_t points) {
    return battery::in_a_process([&]() -> std::optional<bool> {
      Design plain = d;
      plain.figures.clear();
      const Table t = empty_table(plain, points);
      if (!battery::limit_memory(50'000'000)) return std::nullopt;
      try {
        write_netcdf(folder / "t.nc", t);
      } catch (const std::bad_alloc&) {
        return !fs::exists(partial_path(folder / "t.nc"));
      }
      return false;
    });
  };
  for (const std::size_t points : {10, 150'000}) {
    EXPECT_EQ(refuses(points), std::optional(false)) << points;
    EXPECT_TRUE(fs::remove(folder / "t.nc")) << points;
  }
  EXPECT_EQ(refuses(1'000'000), std::optional(true));
}

/// Ends with an open file of the library behind it, as where a disk was full and it could not be closed.
void exit_beside_an_open_file(const fs::path& folder) {
  const Design d = two_by_two();
  write_netcdf(folder / "t.nc", empty_table(d, 4));
  int id = -1;
  require(nc_create((folder / "open.nc").c_str(), NC_NETCDF4 | NC_CLOBBER, &id));
  require(nc_put_att_text(id, NC_GLOBAL, "title", 4, "open"));
  std::exit(0);
}

/// HDF5 would write to files again at the end, and crash where it cannot.
TEST(TableNetcdfDeathTest, leaves_files_alone_at_exit) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  constexpr const char* of_parent = "TDBD_FOLDER_AT_EXIT";  // the process that ends has the same
  setenv(of_parent, empty_folder("at_exit").c_str(), 0);
  const fs::path folder = std::getenv(of_parent);
  EXPECT_EXIT(exit_beside_an_open_file(folder), testing::ExitedWithCode(0), "");
  EXPECT_TRUE(fs::exists(folder / "t.nc"));
  int id = -1;
  EXPECT_NE(nc_open((folder / "open.nc").c_str(), NC_NOWRITE, &id), NC_NOERR);
}

}  // namespace tdbd::sweep::table_netcdf_test

namespace tdbd::sweep::table_test {

Design two_by_two() {
  Design d;
  d.figures = {"cost", "gain"};
  d.factors = {{"size", {{{"1 mm", ""}, 1.0, "mm"}, {{"2 mm", ""}, 2.0, "mm"}}, {}},
               {"kind", {{{"a, b", ""}, {}, ""}, {{"7", ""}, 7.0, ""}}, {}}};
  d.goals = {{"cost", Sense::smaller}, {"gain", Sense::larger}};
  return d;
}

PointRecord record_with(double cost, double gain) {
  return {{PointStatus::done, "h", "", {cost, gain}, false}, 0.5};
}

TEST(Table, has_a_row_for_each_point) {
  const Design d = two_by_two();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const PointRecords records{
      {"0", record_with(1.0, 1.0)},
      {"1", record_with(2.0, 1.0)},
      {"2", {{PointStatus::failed, "", "no, \"never\"", {none, none}, false}, 0.5}}};
  const Table t = table_of(d, points_of(d), {"0", "1", "2", "3"}, records);
  EXPECT_EQ(done_points(t), 3);
  EXPECT_EQ(to_csv(t),
            "point,size [mm],kind,cost,gain,front,status,case_hash,message\n"
            "0,1,\"a, b\",1,1,1,done,h,\n"
            "1,1,7,2,1,0,done,h,\n"
            "2,2,\"a, b\",nan,nan,0,failed,,\"no, \"\"never\"\"\"\n"
            "3,2,7,nan,nan,0,missing,,\n");
}

TEST(Table, of_a_filter_has_what_was_judged_and_what_was_left_out) {
  Design d = two_by_two();
  d.goals.clear();
  d.filter = Filter{{"imbalance", Sense::smaller}, 1, 0};
  const PointRecords records{{"2", record_with(1.0, 1.0)}, {"3", record_with(2.0, 1.0)}};
  const Table t = table_of(d, points_of(d), {"0", "1", "2", "3"}, records,
                           judged_by(*d.filter, {0.5, 0.25, 0.125, 4.0}));
  EXPECT_EQ(points_to_run(t), 2);  // with the unchanged case
  EXPECT_EQ(to_csv(t),
            "point,size [mm],kind,planar.imbalance,cost,gain,status,case_hash,message\n"
            "0,1,\"a, b\",0.5,nan,nan,left-out,,\n"
            "1,1,7,0.25,nan,nan,left-out,,\n"
            "2,2,\"a, b\",0.125,1,1,done,h,\n"
            "3,2,7,4,nan,nan,left-out,,\n");
}

TEST(Table, states_which_means_are_steady_if_any_point_does) {
  Design d = two_by_two();
  d.goals.clear();
  PointRecord steady = record_with(1.0, 1.0), not_steady = record_with(2.0, 2.0);
  steady.outcome.steady = Steady::yes;
  not_steady.outcome.steady = Steady::no;
  const PointRecords records{{"0", steady}, {"1", not_steady}, {"2", record_with(3.0, 3.0)}};
  EXPECT_EQ(to_csv(table_of(d, points_of(d), {"0", "1", "2", "3"}, records)),
            "point,size [mm],kind,cost,gain,steady,status,case_hash,message\n"
            "0,1,\"a, b\",1,1,yes,done,h,\n"
            "1,1,7,2,2,no,done,h,\n"
            "2,2,\"a, b\",3,3,unknown,done,h,\n"
            "3,2,7,nan,nan,unknown,missing,,\n");
}

/// The first point of Sobol is the middle.
TEST(Table, has_sampled_factors_as_numbers) {
  Design d;
  d.figures = {"cost"};
  d.factors = {{"size", {}, Interval{1.0, 2.0, "mm", Scale::linear}}};
  d.sampling = Sampling::sobol;
  d.samples = 1;
  EXPECT_EQ(to_csv(table_of(d, points_of(d), {"0"}, {})),
            "point,size [mm],cost,status,case_hash,message\n0,1.5,nan,missing,,\n");
}

}  // namespace tdbd::sweep::table_test

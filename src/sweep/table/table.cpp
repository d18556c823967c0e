#include "sweep/table/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/netcdf_file.hpp"
#include "io/whole_file.hpp"

namespace tdbd::sweep {
namespace {

using Row = std::vector<double>;

/// Returns the values of the goals with signs such that smaller is better.
Row costs_of(const Row& row, const std::vector<Goal>& goals) {
  Row costs = row;
  for (std::size_t k = 0; k < costs.size(); ++k)
    if (goals[k].sense == Sense::larger) costs[k] = -costs[k];
  return costs;
}

/// Whether `a` is as good in every goal and better in one.
bool dominates(const Row& a, const Row& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

/// A file with its only dimension.
struct TableFile {
  NetcdfFile file;
  int point = -1;

  int define(const std::string& name, NetcdfType type, const std::string& units,
             const std::string& long_name) {
    return file.variable({name, type, {point}, units, long_name});
  }
};

void put_numbers(TableFile& f, const std::string& name, const std::string& units,
                 const std::string& long_name, const std::vector<double>& values) {
  f.file.put(f.define(name, NetcdfType::real, units, long_name), values);
}

void put_texts(TableFile& f, const std::string& name, const std::string& long_name,
               const std::vector<std::string>& texts) {
  f.file.put(f.define(name, NetcdfType::text, "", long_name), texts);
}

void put_flags(TableFile& f, const std::string& name, const std::string& meanings,
               const std::string& long_name, const std::vector<signed char>& values,
               const std::vector<signed char>& flags) {
  const int variable = f.define(name, NetcdfType::flag, "", long_name);
  f.file.attribute(variable, "flag_values", flags);
  f.file.attribute(variable, "flag_meanings", meanings);
  f.file.put(variable, values);
}

/// Returns one value of each point.
template <class Value, class Of>
std::vector<Value> column(const Table& t, Of&& of) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < t.points.size(); ++i) values.push_back(of(i));
  return values;
}

void put_factors(TableFile& f, const Table& t) {
  for (std::size_t k = 0; k < t.factors.size(); ++k) {
    const FactorColumn& factor = t.factors[k];
    if (factor.numbers)
      put_numbers(f, factor.key, factor.unit.empty() ? "1" : factor.unit, "factor " + factor.key,
                  column<double>(t, [&](std::size_t i) { return *t.levels[i][k].number; }));
    else
      put_texts(f, factor.key, "factor " + factor.key,
                column<std::string>(t, [&](std::size_t i) { return t.levels[i][k].word.text; }));
  }
}

void put_outcomes(TableFile& f, const Table& t) {
  const auto outcome = [&](std::size_t i) {
    return t.points[i] == nullptr ? PointOutcome{} : t.points[i]->outcome;
  };
  put_flags(f, "status", "done failed missing left_out", "how the point ended",
            column<signed char>(t,
                                [&](std::size_t i) {
                                  if (!t.judged.keeps(i)) return static_cast<signed char>(3);
                                  if (t.points[i] == nullptr) return static_cast<signed char>(2);
                                  return static_cast<signed char>(
                                      t.points[i]->outcome.status == PointStatus::failed ? 1 : 0);
                                }),
            {0, 1, 2, 3});
  if (!t.design->goals.empty())
    put_flags(f, "front", "dominated not_dominated",
              "whether no other point is as good in every goal and better in one",
              column<signed char>(
                  t, [&](std::size_t i) { return static_cast<signed char>(t.on_front[i]); }),
              {0, 1});
  if (t.states_steadiness)
    put_flags(f, "steady", "no yes unknown", "whether the means are steady",
              column<signed char>(
                  t, [&](std::size_t i) { return static_cast<signed char>(outcome(i).steady); }),
              {0, 1, 2});
  put_texts(f, "case_hash", "of the resolved case",
            column<std::string>(t, [&](std::size_t i) { return outcome(i).case_hash; }));
  put_texts(f, "message", "why the point failed",
            column<std::string>(t, [&](std::size_t i) { return outcome(i).message; }));
}

void put_figures(TableFile& f, const Table& t) {
  if (t.design->filter)
    put_numbers(f, "planar." + t.design->filter->goal.figure, "",
                "filter planar." + t.design->filter->goal.figure, t.judged.figure);
  for (std::size_t k = 0; k < t.design->figures.size(); ++k)
    put_numbers(f, t.design->figures[k], "", "figure " + t.design->figures[k],
                column<double>(t, [&](std::size_t i) {
                  return t.points[i] == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                                : t.points[i]->outcome.figures[k];
                }));
}

void put_head(TableFile& f, const Design& d) {
  const Provenance& p = provenance();
  f.file.attribute(NetcdfFile::global, "title", d.title);
  f.file.attribute(NetcdfFile::global, "command", name_of(d.command));
  f.file.attribute(NetcdfFile::global, "source", fmt::format("tdbd {} {}", p.version, p.commit));
  std::string goals;
  for (const Goal& goal : d.goals)
    goals += fmt::format("{}{} {}", goals.empty() ? "" : ", ", goal.figure,
                         goal.sense == Sense::smaller ? "smaller" : "larger");
  if (!goals.empty()) f.file.attribute(NetcdfFile::global, "goals", goals);
}

}  // namespace

/// In lexicographic order a row can only be dominated by an earlier one, and then also by a row of
/// the front found so far (Kung, Luccio and Preparata 1975).
std::vector<char> front_of(const std::vector<Row>& rows, const std::vector<Goal>& goals) {
  std::vector<char> on_front(rows.size(), 0);
  if (goals.empty()) return on_front;
  std::vector<Row> costs;
  costs.reserve(rows.size());
  for (const Row& row : rows) costs.push_back(costs_of(row, goals));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (std::ranges::all_of(costs[i], [](double x) { return std::isfinite(x); }))
      order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) -> const Row& { return costs[i]; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (std::ranges::any_of(front, [&](std::size_t j) { return dominates(costs[j], costs[i]); }))
      continue;
    front.push_back(i);
    on_front[i] = 1;
  }
  return on_front;
}

void write_netcdf(const std::filesystem::path& file, const Table& t) {
  constexpr std::size_t own = 8'000'000, by_cell = 64;
  TableFile f{{partial_path(file), NetcdfFile::Use::create, own + by_cell * t.points.size()}};
  f.point = f.file.dimension("point", t.points.size());
  put_head(f, *t.design);
  put_factors(f, t);
  put_figures(f, t);
  put_outcomes(f, t);
  f.file.close();
  rename_partial(file);
}

namespace fs = std::filesystem;

namespace {

/// Returns a column of numbers if all levels are numbers in one unit, otherwise a column of texts.
FactorColumn column_of(const Factor& f) {
  if (f.levels.empty()) return {f.key, f.interval->unit, true};
  const Level& first = f.levels.front();
  const bool numbers = std::ranges::all_of(
      f.levels, [&](const Level& l) { return l.number.has_value() && l.unit == first.unit; });
  return {f.key, numbers ? first.unit : "", numbers};
}

std::vector<char> front_in(const Table& t) {
  const Design& d = *t.design;
  std::vector<std::size_t> columns;
  for (const Goal& goal : d.goals)
    columns.push_back(
        static_cast<std::size_t>(std::ranges::find(d.figures, goal.figure) - d.figures.begin()));
  std::vector<std::vector<double>> rows;
  for (const PointRecord* point : t.points) {
    std::vector<double>& row = rows.emplace_back();
    for (const std::size_t column : columns)
      row.push_back(point == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                     : point->outcome.figures[column]);
  }
  return front_of(rows, d.goals);
}

/// Returns a cell of a CSV file, in quotes if it contains a comma, a quote or a new line (RFC
/// 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string header_of(const FactorColumn& f) {
  return cell(f.unit.empty() ? f.key : fmt::format("{} [{}]", f.key, f.unit));
}

std::string number_cell(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "nan"; }

std::string status_of(const Table& t, std::size_t i) {
  const PointRecord* point = t.points[i];
  if (!t.judged.keeps(i)) return "left-out";
  if (point == nullptr) return "missing";
  return point->outcome.status == PointStatus::done ? "done" : "failed";
}

std::string row_of(const Table& t, std::size_t i) {
  std::string row = fmt::format("{}", i);
  for (std::size_t k = 0; k < t.factors.size(); ++k)
    row += "," + (t.factors[k].numbers ? number_cell(*t.levels[i][k].number)
                                       : cell(t.levels[i][k].word.text));
  const PointRecord* point = t.points[i];
  if (t.design->filter) row += "," + number_cell(t.judged.figure[i]);
  for (std::size_t k = 0; k < t.design->figures.size(); ++k)
    row += "," + (point == nullptr ? "nan" : number_cell(point->outcome.figures[k]));
  if (!t.design->goals.empty()) row += fmt::format(",{}", static_cast<int>(t.on_front[i]));
  if (t.states_steadiness)
    row += fmt::format(",{}", name_of(point == nullptr ? Steady::unknown : point->outcome.steady));
  row +=
      fmt::format(",{},{},{}\n", status_of(t, i), point == nullptr ? "" : point->outcome.case_hash,
                  cell(point == nullptr ? "" : point->outcome.message));
  return row;
}

/// Renames a file within a file system: readers see either the previous file or this one.
void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

std::string timing_csv(const Table& t) {
  std::string text = "point,seconds\n";
  for (std::size_t i = 0; i < t.points.size(); ++i)
    if (t.points[i] != nullptr) text += fmt::format("{},{:.4f}\n", i, t.points[i]->seconds);
  return text;
}

}  // namespace

Table table_of(const Design& d, const Points& points, const std::vector<std::string>& keys,
               const PointRecords& records, const Judged& judged) {
  Table t;
  t.judged = judged;
  t.design = &d;
  for (const Factor& f : d.factors) t.factors.push_back(column_of(f));
  for (long i = 0; i < points.count; ++i) {
    t.levels.push_back(levels_at(d, points, i));
    const auto found = records.find(keys[static_cast<std::size_t>(i)]);
    const bool left_out = !judged.keeps(static_cast<std::size_t>(i));
    t.points.push_back(found == records.end() || left_out ? nullptr : &found->second);
    if (t.points.back() != nullptr && t.points.back()->outcome.steady != Steady::unknown)
      t.states_steadiness = true;
  }
  t.on_front = front_in(t);
  return t;
}

long done_points(const Table& t) {
  return std::ranges::count_if(t.points, [](const PointRecord* p) { return p != nullptr; }) +
         (t.unchanged != nullptr ? 1 : 0);
}

long points_to_run(const Table& t) {
  long count = t.design->filter ? 1 : 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) count += t.judged.keeps(i) ? 1 : 0;
  return count;
}

std::string to_csv(const Table& t) {
  std::string text = "point";
  for (const FactorColumn& f : t.factors) text += "," + header_of(f);
  if (t.design->filter) text += ",planar." + cell(t.design->filter->goal.figure);
  for (const std::string& figure : t.design->figures) text += "," + cell(figure);
  if (!t.design->goals.empty()) text += ",front";
  if (t.states_steadiness) text += ",steady";
  text += ",status,case_hash,message\n";
  for (std::size_t i = 0; i < t.points.size(); ++i) text += row_of(t, i);
  return text;
}

void write_table(const fs::path& netcdf_file, const Table& t, const fs::path& own_folder) {
  fs::path csv = netcdf_file, timing = netcdf_file;
  csv.replace_extension(".csv");
  timing.replace_filename(timing.stem().string() + "_timing.csv");
  const auto here = [&own_folder](const fs::path& file) { return own_folder / file.filename(); };
  write_text(here(timing), timing_csv(t));
  write_text(here(csv), to_csv(t));
  if (t.design->filter) {
    fs::path filter = netcdf_file;
    filter.replace_filename(filter.stem().string() + "_filter.csv");
    write_text(here(filter), filter_csv(*t.design, t.judged, t.points, t.unchanged));
    move(here(filter), filter);
  }
  write_netcdf(here(netcdf_file), t);
  for (const fs::path& file : {timing, csv, netcdf_file}) move(here(file), file);
}

}  // namespace tdbd::sweep
